// Constant forces in all springs at a DOF that are one wrong zero: 1000 N/m to the ground and 500 N/m to mass 2.
#include "host_sim/diagnosis/channels/zero_of_channel.hpp"

#include <gtest/gtest.h>

namespace {

using diagnosis::Cause;
using diagnosis::Diagnosis;

rig_file::RigModel two_springs() {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(2);
  rig.links[0].a = 1, rig.links[0].b = 0, rig.links[0].stiffness_N_m.value = 1000;
  rig.links[1].a = 1, rig.links[1].b = 2, rig.links[1].stiffness_N_m.value = 500;
  return rig;
}

Cause force(const std::string& link, double newton) {
  Cause c;
  c.effect = "force_offset", c.where = "link " + link;
  c.parameters = {{"force_offset[" + link + "]", newton, "N", 0.001, true}};
  return c;
}

Diagnosis named(const std::vector<Cause>& causes) {
  const diagnosis::System system = diagnosis::make_system(two_springs());
  std::vector<diagnosis::runs::Prepared> records(1);
  for (int dof = 0; dof < 2; ++dof) {
    diagnosis::runs::MotionTrace trace;
    trace.dof = dof, trace.channel = "displacement_" + std::to_string(dof + 1) + "_m";
    records[0].traces.push_back(trace);
  }
  const diagnosis::runs::Task task{system, records, 1};
  Diagnosis d;
  d.causes = causes;
  diagnosis::runs::name_zeros(task, d);
  return d;
}

// Reading 1 mm too much at mass 1: both springs seem to pull 1 N and 0.5 N less.
TEST(ZeroOfChannel, BothForcesOfAMassAreOneZero) {
  const Diagnosis d = named({force("1-0", -1), force("1-2", -0.5)});
  ASSERT_EQ(d.causes.size(), 1u);
  EXPECT_EQ(d.causes[0].effect, "sensor_offset");
  EXPECT_EQ(d.causes[0].where, "channel displacement_1_m");
  EXPECT_EQ(d.causes[0].parameters[0].name, "sensor_offset[displacement_1_m]");
  EXPECT_NEAR(d.causes[0].parameters[0].value, 1e-3, 1e-9);
  EXPECT_GT(d.causes[0].parameters[0].std, 0);
}

// 1 mm and 2 mm are no one zero; and where one spring alone holds mass 2 the force stays.
TEST(ZeroOfChannel, ForcesThatDoNotAgreeStay) {
  for (const auto& causes : {std::vector<Cause>{force("1-0", -1), force("1-2", -1)},
                             {force("1-2", -0.5)},
                             {force("1-0", -1)},
                             {force("1-0", -1), force("1-2", 0.5)}}) {
    const Diagnosis d = named(causes);
    ASSERT_EQ(d.causes.size(), causes.size());
    for (const Cause& c : d.causes) EXPECT_EQ(c.effect, "force_offset");
  }
}

}  // namespace
