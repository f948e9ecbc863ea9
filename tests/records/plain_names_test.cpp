// Recordings of one part: heads without a DOF's number, and tables without heads.
#include <gtest/gtest.h>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/columns/names/plain_name.hpp"
#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

using host_sim::Quantity;
using host_sim::ReadingOptions;
using host_sim::Record;

rig_file::RigModel one_dof(bool rotating) {
  return rig_file::parse_rig(std::string("schema = \"rig/1\"\n[[dof]]\n") + (rotating ? "inertia_kg_m2" : "mass_kg") +
                                 " = 1\n[[link]]\nbetween = [1, 0]\n" +
                                 (rotating ? "viscous_N_m_s_rad" : "viscous_N_s_m") + " = \"estimate\"\n",
                             "rig.toml");
}

std::string refusal(const std::string& text, const rig_file::RigModel& rig, const ReadingOptions& options = {}) {
  try {
    host_sim::parse_csv(text, "d.csv", rig, options);
  } catch (const host_sim::DataFileError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(PlainNames, AreAQuantityAndItsUnit) {
  struct Row {
    const char *name, *unit, *channel;  // channel "": none
  };
  const Row rows[] = {{"Position", "m", "displacement_1_m"},
                      {"position", "deg", "angle_1_rad"},
                      {"Angular Velocity", "rad/s", "angular_velocity_1_rad_s"},
                      {"speed", "rpm", "angular_velocity_1_rad_s"},
                      {"speed", "m/s", "velocity_1_m_s"},
                      {"Acceleration", "g", "acceleration_1_m_s2"},
                      {"load_kN", "", "force_1_N"},
                      {"Angle_deg", "", "angle_1_rad"},
                      {"Force", "", "force_1_N"},
                      {"AngVel", "rad/s", "angular_velocity_1_rad_s"},
                      {"acc", "g", "acceleration_1_m_s2"},
                      {"Disp", "mm", "displacement_1_m"},
                      {"Weg &b_A1", "rad", "angle_1_rad"},  // an interface's input behind the name
                      {"Weg s_A1", "m", "displacement_1_m"},
                      {"Winkel phi", "rad", "angle_1_rad"},  // its usual symbol
                      {"Weg s", "mm", "displacement_1_m"},
                      {"Geschwindigkeit v", "m/s", "velocity_1_m_s"},
                      {"Kraft F", "N", "force_1_N"},
                      {"Weg a", "m", ""},
                      {"Winkel", "rad", "angle_1_rad"},
                      {"theta", "deg", "angle_1_rad"},
                      {"phi_rad", "", "angle_1_rad"},
                      {"omega", "rad/s", "angular_velocity_1_rad_s"},
                      {"rate_deg_s", "", "angular_velocity_1_rad_s"},
                      {"rate", "Hz", ""},
                      {"sigma_phi_rad", "", ""},
                      {"Kraft F_B1", "N", "force_1_N"},
                      {"Acceleration x", "m/s^2", ""},  // one of three axes
                      {"force_ref", "N", ""},
                      {"force_ref", "", ""},
                      {"force_N", "N", ""},  // a unit twice
                      {"Load", "%", ""},
                      {"Position", "m/s", ""},
                      {"Temperature", "C", ""},
                      {"positions", "m", ""}};
  for (const Row& row : rows) {
    const auto plain = host_sim::parse_plain_name(row.name, row.unit);
    EXPECT_EQ(plain ? rig_file::format_channel_name(plain->channel) : "", row.channel)
        << row.name << " in " << row.unit;
  }
}

// 90 degrees are pi / 2; the speed's column begins a row later and ends a row earlier, as what a program derives does.
TEST(PlainNames, OfOneDofAreItsChannels) {
  const std::string text =
      "\xEF\xBB\xBF\"Time (s) Run #1\";\"Angle (deg) Run #1\";\"Angular Velocity (rad/s) Run #1\";\"Light (lx)\"\r\n"
      "0,000;0;;1\r\n0,100;90;-0,5;1\r\n0,200;45;0,25;1\r\n0,300;0;;1\r\n";
  for (const rig_file::RigModel& rig : {one_dof(true), rig_file::RigModel()}) {
    const Record record = host_sim::parse_csv(text, "d.csv", rig);
    ASSERT_EQ(record.channels.size(), 2u);
    ASSERT_EQ(record.samples(), 2u);
    EXPECT_DOUBLE_EQ(record.start_s, 0.1);
    EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[0], 1.5707963267948966);
    EXPECT_DOUBLE_EQ(record.find(Quantity::kVelocity, 1)->values[1], 0.25);
    ASSERT_EQ(record.notes.size(), 4u);
    EXPECT_EQ(record.notes[0], "angle_1_rad from column \"Angle (deg) Run #1\" in deg: values times 0.01745329252");
    EXPECT_EQ(record.notes[2], "ignored: \"Light (lx)\"");
  }
}

TEST(PlainNames, StandForNothingWhereTheySayTooLittle) {
  // no unit; twice; of the other kind; beside a channel's own name
  EXPECT_NE(refusal("time,angle\n0,1\n1,1\n", one_dof(true)).find("--column angle_1=\"angle\""), std::string::npos);
  EXPECT_NE(refusal("time,angle\n0,1\n1,1\n", one_dof(false)).find("--column displacement_1=\"angle\""),
            std::string::npos);
  EXPECT_NE(refusal("t [s],Acceleration a_x [m/s^2],Acceleration a_y [m/s^2]\n0,1,1\n1,1,1\n", one_dof(false))
                .find("--column acceleration_1=\"Acceleration a_x [m/s^2]\""),
            std::string::npos);
  // all of them at once, to be copied
  EXPECT_NE(
      refusal("time,position,velocity,torque\n0,1,1,1\n1,1,1,1\n", one_dof(true))
          .find("--column angle_1=\"position\" --column angular_velocity_1=\"velocity\" --column torque_1=\"torque\""),
      std::string::npos);
  EXPECT_NE(refusal("time,y\n0,1\n1,1\n", one_dof(true)).find("--column angle_1=NAME"), std::string::npos);
  EXPECT_NE(refusal("time,Force (N),Force (kN)\n0,1,1\n1,1,1\n", one_dof(false)).find("names no channel"),
            std::string::npos);
  EXPECT_NE(refusal("time,Angle (deg)\n0,1\n1,1\n", one_dof(false)).find("names no channel"), std::string::npos);
  const Record named = host_sim::parse_csv("t_s,Force (N),displacement_1_m\n0,1,2\n1,1,2\n", "d.csv", one_dof(false));
  EXPECT_EQ(named.channels.size(), 1u);
  auto two = one_dof(false);
  two.dofs.push_back(two.dofs[0]);
  EXPECT_NE(refusal("time,Position (m)\n0,1\n1,1\n", two).find("names no channel"), std::string::npos);
}

// Who says of one column what it is still has the others; 2 kN are 2000 N, 1 g is 9.80665 m/s^2.
TEST(PlainNames, StandBesideWhatTheUserSays) {
  const char* text = "Time [s];Force [kN];LVDT 2 [mm];Disp [mm];Acc [g]\n0;2;5;7;1\n1;2;5;7;1\n";
  ReadingOptions options;
  options.columns = {{"displacement_1", "LVDT 2 [mm]"}};
  const Record record = host_sim::parse_csv(text, "d.csv", one_dof(false), options);
  ASSERT_EQ(record.channels.size(), 3u);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kForce, 1)->values[1], 2000);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[1], 5e-3);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kAcceleration, 1)->values[1], 9.80665);
  EXPECT_EQ(record.notes.back(), "ignored: \"Disp [mm]\"");
}

// A channel that the user does not trust, by any name that the file may have for it.
TEST(PlainNames, MayBeLeftOut) {
  ReadingOptions options;
  options.columns = {{"acceleration_1", ""}};
  for (const char* name : {"Acc [g]", "acceleration_1_m_s2", "acceleration_1_g"}) {
    const bool own = std::string(name) != "Acc [g]";
    const std::string text = std::string("Time [s];") + (own ? "force_1_N;" : "Force [N];") + name + "\n0;2;1\n1;2;1\n";
    const Record record = host_sim::parse_csv(text, "d.csv", one_dof(false), options);
    ASSERT_EQ(record.channels.size(), 1u) << name;
    EXPECT_EQ(record.channels[0].quantity, Quantity::kForce) << name;
    EXPECT_EQ(record.notes.back(), "ignored: \"" + std::string(name) + "\"");
  }
}

TEST(PlainNames, UnitsMayStandBehindASlash) {
  const Record record = host_sim::parse_csv("Time/s,Angle / deg,AngVel/rad/s\n0,90,1\n1,0,2\n", "d.csv", one_dof(true));
  EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[0], 1.5707963267948966);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kVelocity, 1)->values[1], 2);
  // a row of units is no row of quantities over theirs
  const Record units = host_sim::parse_csv("t_s,velocity_1\ns,mm/s\n0,1\n1,2\n", "d.csv", one_dof(false));
  EXPECT_DOUBLE_EQ(units.find(Quantity::kVelocity, 1)->values[1], 2e-3);
}

// The names below a preamble are found by them.
TEST(PlainNames, AreFoundBelowAPreamble) {
  const Record record = host_sim::parse_csv("Test 7\nOperator;Miller\nTime (s);Load (kN);Stroke (mm)\n0;1;2\n1;1;2\n",
                                            "d.csv", one_dof(false));
  EXPECT_DOUBLE_EQ(record.find(Quantity::kForce, 1)->values[1], 1000);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[1], 2e-3);
}

// Columns of a table without names are told by their places. The first row counts, also where it holds a place's number. A title has a
// blank line below it, though it has as many words as there are columns.
TEST(PlainNames, TablesWithoutNamesHaveNumberedColumns) {
  ReadingOptions options;
  options.columns = {{"t", "1"}, {"force_1", "3"}};
  for (const char* text :
       {"0 1 3\n0.5 1 4\n1 2 5\n", "0,1,3\n0.5,1,4\n1,2,5\n", "# run 3\n\n 0\t1\t3\n0.5\t1\t4\n1\t2\t5\n",
        "0;1;3\n0,5;1;4\n1;2;5\n", "Frequency without coupling\n\n0 1 3\n0.5 1 4\n1 2 5\n"}) {
    const Record record = host_sim::parse_csv(text, "d.csv", one_dof(false), options);
    EXPECT_DOUBLE_EQ(record.sample_period_s, 0.5);
    EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{3, 4, 5})) << text;
  }
  options.columns = {{"force_1", "1"}}, options.sample_rate_Hz = 10;
  EXPECT_EQ(host_sim::parse_csv("3\n4\n", "d.csv", one_dof(false), options).channels[0].values,
            (std::vector<double>{3, 4}));
}

}  // namespace
