// Units written out, and a row of them in which one is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/columns/units/units.hpp"
#include "host_sim/records/csv/csv_reader.hpp"

namespace {

// LabVIEW's header: what the row of units says of force and displacement.
std::string labview(const std::string& force_unit, const std::string& displacement_unit) {
  std::string text = "LabVIEW Measurement\t\n***End_of_Header***\t\n\t\nY_Unit_Label\t" + force_unit + "\t" +
                     displacement_unit +
                     "\nX_Dimension\tTime\tTime\n***End_of_Header***\t\t\nX_Value\tForce 1\tDisplacement 1\tComment\n";
  return text + "0\t2\t-4\n0.5\t1\t8\n1\t-3\t12\n";
}

host_sim::Record read(const std::string& force_unit, const std::string& displacement_unit) {
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 800.0\n"
      "viscous_N_s_m = \"estimate\"\n",
      "rig.toml");
  return host_sim::parse_csv(labview(force_unit, displacement_unit), "d.lvm", rig);
}

std::string refusal(const std::string& force_unit, const std::string& displacement_unit) {
  try {
    read(force_unit, displacement_unit);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

// 2 lbf = 8.896443 N; -4 in = -0.1016 m.
TEST(UnitWords, WrittenOutTheyAreTheSameUnits) {
  const host_sim::Record record = read("Pounds", "Inches");
  ASSERT_EQ(record.channels.size(), 2u);
  EXPECT_NEAR(record.channels[0].values[0], 8.896443, 1e-6);
  EXPECT_NEAR(record.channels[1].values[0], -0.1016, 1e-9);
  EXPECT_DOUBLE_EQ(read("Newtons", "meters").channels[0].values[0], 2.0);
  EXPECT_DOUBLE_EQ(host_sim::find_unit("newton", host_sim::Dimension::kForce)->to_si, 1.0);
}

// One word that is no unit used to take the whole row away: pounds were newtons then.
TEST(UnitWords, OneThatIsNoUnitIsToldAndTheOthersStay) {
  EXPECT_NE(refusal("Pounds", "furlong").find("\"furlong\""), std::string::npos) << refusal("Pounds", "furlong");
  EXPECT_NE(refusal("Volts", "mm").find("voltage"), std::string::npos) << refusal("Volts", "mm");
  EXPECT_EQ(refusal("N", "mm"), "");
}

// An encoder whose step is 17.857 um, a clock of 250 us: 56 steps are 1 mm, 4 ticks 1 ms. A sensor turned over has -1 of its unit.
TEST(UnitWords, SoManyOfAUnitAreAScale) {
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 800.0\n"
      "viscous_N_s_m = \"estimate\"\n",
      "rig.toml");
  const std::string text = "ticks,pos,acc\n0,0,1\n4,56,-2\n8,112,4\n";
  host_sim::ReadingOptions options;
  options.columns = {{"t", "ticks"}, {"displacement_1", "pos"}, {"acceleration_1", "acc"}};
  options.units = {{"t", "250 us"}, {"displacement_1", "17.857um"}, {"acceleration_1", "-1 g"}};
  const host_sim::Record record = host_sim::parse_csv(text, "d.csv", rig, options);
  EXPECT_NEAR(record.sample_period_s, 1e-3, 1e-15);
  EXPECT_NEAR(record.find(host_sim::Quantity::kDisplacement, 1)->values[1], 0.999992e-3, 1e-12);
  EXPECT_NEAR(record.find(host_sim::Quantity::kAcceleration, 1)->values[1], 2 * 9.80665, 1e-12);
  const std::string told = "displacement_1_m from column \"pos\" in 17.857 um: values times 1.7857e-05";
  EXPECT_NE(std::find(record.notes.begin(), record.notes.end(), told), record.notes.end());
  for (const char* none : {"17.857", "0 um", "17,857 um", "inf um", "um 17.857", "2 kg"}) {
    options.units[1].second = none;
    EXPECT_THROW(host_sim::parse_csv(text, "d.csv", rig, options), std::exception) << none;
  }
  EXPECT_NEAR(host_sim::find_scaled_unit("1/min", host_sim::Dimension::kAngularVelocity)->to_si, M_PI / 30, 1e-15);
  EXPECT_NEAR(host_sim::find_scaled_unit("2 1/min", host_sim::Dimension::kAngularVelocity)->to_si, M_PI / 15, 1e-15);
}

}  // namespace
