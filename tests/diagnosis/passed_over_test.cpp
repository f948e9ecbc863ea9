// A cause that is passed over for a simpler one, which then wants a further one.
#include <algorithm>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// Three decays of three masses, velocities. A backlash of 10 um in a motion of a millimetre leaves no less than a wrong spring does,
// which is simpler; but beside that spring a hardening one is seen as well, and both were named with numbers that were VALID.
TEST(PassedOver, ABacklashIsNotAWrongSpringAndAHardeningOne) {
  hidden_rig::Settings settings;
  settings.condition = "free_decay", settings.sensors = "v", settings.hidden = "backlash", settings.rho_low = 0.1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(43400018, settings);
  ASSERT_EQ(draw.hidden.size(), 1u);
  ASSERT_EQ(draw.hidden[0].where, "link 1-0");
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  EXPECT_EQ(d.causes.size(), 1u) << two_masses::said(d);
  const diagnosis::NamedPlace backlash{"backlash", "link 1-0"}, spring{"stiffness_error", "link 1-0"};
  const auto told = [&](const diagnosis::NamedPlace& place) {
    return d.names(place.effect, place.where) ||
           std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) != d.ambiguous_with.end();
  };
  EXPECT_TRUE(told(backlash)) << two_masses::said(d);
  EXPECT_FALSE(told(spring)) << two_masses::said(d);
}

}  // namespace
