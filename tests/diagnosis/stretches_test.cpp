// What of long records the first screen looks at.
#include "host_sim/diagnosis/first_screen/stretches.hpp"

#include <gtest/gtest.h>

namespace {

rig_file::RigModel one_mass_on_ground() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  return rig;
}

// Sample k of every channel is k.
host_sim::Record counted(size_t samples) {
  host_sim::Record r;
  r.file = "counted", r.sample_period_s = 0.001, r.start_s = 5.0;
  r.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, {}},
                {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
  for (host_sim::Channel& c : r.channels)
    for (size_t k = 0; k < samples; ++k) c.values.push_back(static_cast<double>(k));
  return r;
}

}  // namespace

TEST(Stretches, RecordsThatFitStayAsTheyAre) {
  const auto list = diagnosis::stretches(one_mass_on_ground(), {counted(20000), counted(30000)});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].samples(), 20000u);
  EXPECT_EQ(list[1].samples(), 30000u);
}

// 250,000 values for 1 DOF and 1 link are 125,000 samples: half of a record of 250,000. Four stretches of 31,250; what is left
// over, 218,750, lies around them: they begin at 1/8, 3/8, 5/8 and 7/8 of it.
TEST(Stretches, OfALongRecordAreSpreadEvenly) {
  const auto list = diagnosis::stretches(one_mass_on_ground(), {counted(250000)});
  ASSERT_EQ(list.size(), 4u);
  const double first[] = {27343, 82031, 136718, 191406};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(list[i].samples(), 31250u);
    ASSERT_EQ(list[i].channels.size(), 2u);
    for (const host_sim::Channel& c : list[i].channels) {
      EXPECT_EQ(c.values.front(), first[i]);
      EXPECT_EQ(c.values.back(), first[i] + 31249);
    }
    EXPECT_DOUBLE_EQ(list[i].start_s, 5.0 + 0.001 * first[i]);
  }
}

// A short record beside a long one keeps one stretch that rows can be made of, or itself.
TEST(Stretches, AShortRecordBesideALongOneIsKept) {
  const auto list = diagnosis::stretches(one_mass_on_ground(), {counted(1000000), counted(3000), counted(9000)});
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[4].samples(), 3000u);
  EXPECT_EQ(list[5].samples(), 4096u);
}
