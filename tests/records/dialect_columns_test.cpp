// Columns by the names and units that people give them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "tests/records/two_dofs.hpp"

namespace {

using host_sim::Quantity;
using host_sim::ReadingOptions;
using two_dofs::rig;

// Names that mean nothing to the rig are still told apart, as the rows below them are.
TEST(Dialects, ForeignNamesAreToldOneByOne) {
  try {
    host_sim::parse_csv("Uhr;Kraft 1 [N];Weg 1 [mm]\n0,0;1,5;2\n0,5;1,5;3\n", "d.csv", rig(), {{}, {}, {}, 2.0});
    FAIL() << "no channel is named";
  } catch (const host_sim::DataFileError& e) {
    EXPECT_NE(std::string(e.what()).find("\"Uhr\", \"Kraft 1 [N]\", \"Weg 1 [mm]\""), std::string::npos) << e.what();
  }
}

struct UnitRow {
  const char* head;
  const char* channel;
  double factor;  // by definition of the unit
};

TEST(Dialects, UnitsThatRigsComeIn) {
  const double pi = std::acos(-1.0);
  const UnitRow rows[] = {
      {"displacement_1_mm", "displacement_1_m", 1e-3},
      {"displacement_1_um", "displacement_1_m", 1e-6},
      {"displacement_1 [\xC2\xB5m]", "displacement_1_m", 1e-6},  // the micro sign, UTF-8
      {"displacement_1 [\xB5m]", "displacement_1_m", 1e-6},      // and Latin-1
      {"displacement_1_inch", "displacement_1_m", 0.0254},
      {"velocity_1_mm_s", "velocity_1_m_s", 1e-3},
      {"velocity_1 (mm/s)", "velocity_1_m_s", 1e-3},
      {"acceleration_1_g", "acceleration_1_m_s2", 9.80665},
      {"acceleration_1 (g)", "acceleration_1_m_s2", 9.80665},
      {"acceleration_1 (m/s^2)", "acceleration_1_m_s2", 1.0},
      {"acceleration_1 (m/s\xC2\xB2)", "acceleration_1_m_s2", 1.0},
      {"acceleration_1_mm_s2", "acceleration_1_m_s2", 1e-3},
      {"force_1_kN", "force_1_N", 1e3},
      {"force_1_mN", "force_1_N", 1e-3},
      {"force_1_lbf", "force_1_N", 0.45359237 * 9.80665},
      {"Force_1 (lbf)", "force_1_N", 0.45359237 * 9.80665},
      {"force_1 [kgf]", "force_1_N", 9.80665},
      {"torque_2_N_mm", "torque_2_N_m", 1e-3},
      {"torque_2 (lbf-in)", "torque_2_N_m", 0.45359237 * 9.80665 * 0.0254},
      {"torque_2 [N\xC2\xB7m]", "torque_2_N_m", 1.0},
      {"angle_2_deg", "angle_2_rad", pi / 180.0},
      {"angle_2 [\xC2\xB0]", "angle_2_rad", pi / 180.0},
      {"angle_2_rev", "angle_2_rad", 2.0 * pi},
      {"angular_velocity_2_rpm", "angular_velocity_2_rad_s", pi / 30.0},
      {"angular_velocity_2 [1/min]", "angular_velocity_2_rad_s", pi / 30.0},
      {"angular_velocity_2_deg_s", "angular_velocity_2_rad_s", pi / 180.0},
      {"angular_acceleration_2_deg_s2", "angular_acceleration_2_rad_s2", pi / 180.0},
  };
  for (const UnitRow& row : rows) {
    SCOPED_TRACE(row.head);
    const auto record = host_sim::parse_csv(std::string("t_s;") + row.head + "\n0;2\n1;-4\n2;0\n", "d.csv", rig());
    ASSERT_EQ(record.channels.size(), 1u);
    EXPECT_EQ(record.channels[0].name, row.channel);
    EXPECT_NEAR(record.channels[0].values[1], -4.0 * row.factor, 1e-14 * row.factor);
    char factor[40];
    std::snprintf(factor, sizeof factor, "times %.10g", row.factor);
    if (row.factor != 1.0) {
      ASSERT_EQ(record.notes.size(), 1u);
      EXPECT_NE(record.notes[0].find(factor), std::string::npos) << record.notes[0];
    }
  }
}

// 100 mV/g: 0.25 V are 2.5 g. The column is "Chan 3" in the file.
TEST(Dialects, ColumnsOfTheUsersOwnNames) {
  const std::string text = "Time,Chan 1 [N],Chan 3 [mV],Chan 4\n0,1,250,x\n0.1,2,-100,y\n0.2,3,0,z\n";
  ReadingOptions options;
  options.columns = {{"force_1", "Chan 1"}, {"acceleration_1_m_s2", "Chan 3"}};
  options.sensitivities = {{"acceleration_1", "100 mV/g"}};
  const auto by_options = host_sim::parse_csv(text, "d.csv", rig(), options);
  const auto by_rig = host_sim::parse_csv(
      text, "d.csv",
      rig("[[channel]]\nname = \"force_1_N\"\ncolumn = \"Chan 1\"\n"
          "[[channel]]\nname = \"acceleration_1_m_s2\"\ncolumn = \"Chan 3\"\nsensitivity = \"100 mV/g\"\n"));
  for (const auto* record : {&by_options, &by_rig}) {
    EXPECT_EQ(record->find(Quantity::kForce, 1)->values[2], 3.0);
    EXPECT_NEAR(record->find(Quantity::kAcceleration, 1)->values[0], 2.5 * 9.80665, 1e-12);
    ASSERT_EQ(record->notes.size(), 3u);
    EXPECT_EQ(record->notes[1],
              "acceleration_1_m_s2 from column \"Chan 3 [mV]\" in mV at 100 mV/g: values times 0.0980665");
    EXPECT_EQ(record->notes[2], "ignored: \"Chan 4\"");
  }
}

TEST(Dialects, UnitOfAColumnByOption) {
  ReadingOptions options;
  options.columns = {{"t", "clock"}};
  options.units = {{"displacement_1", "mm"}, {"t", "ms"}};
  const auto record = host_sim::parse_csv("clock,displacement_1\n0,5\n2,6\n4,7\n", "d.csv", rig(), options);
  EXPECT_DOUBLE_EQ(record.sample_period_s, 2e-3);
  EXPECT_DOUBLE_EQ(record.channels[0].values[0], 5e-3);
}

// Without a rig file names alone say what a channel is.
TEST(Dialects, NoRigFileTakesEveryChannel) {
  const auto record = host_sim::parse_csv("t_s,angle_9_rad,force_3_N\n0,1,2\n1,1,2\n", "d.csv", rig_file::RigModel());
  EXPECT_EQ(record.channels.size(), 2u);
}

// What stands above a table of unknown names: a line of the run, or names and values of its settings.
TEST(Dialects, NamesStandAboveAsManyNumbers) {
  ReadingOptions options;
  options.columns = {{"displacement_1", "U ( V )"}};
  options.units = {{"displacement_1", "mm"}};
  const std::string run = "Voltage, ChA, Run #1\nTime ( s )\tU ( V )\n0.0\t1.5\n0.5\t2\n1.0\t-0.003\n";
  const auto said = [](const std::string& text, const ReadingOptions& o) {
    try {
      host_sim::parse_csv(text, "d.csv", rig(), o);
    } catch (const host_sim::DataFileError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  EXPECT_EQ(said(run, options), "read");
  EXPECT_NE(said(run, {}).find("d.csv:2: names no channel (\"Time ( s )\", \"U ( V )\")"), std::string::npos)
      << said(run, {});
  ReadingOptions single;
  single.columns = {{"displacement_1", "1"}};
  single.sample_rate_Hz = 1000;
  const auto record =
      host_sim::parse_csv("start_deg, rate, duration\n90, 1000, 5 \n1.5\n2\n-3e-3\n", "d.csv", rig(), single);
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{1.5, 2, -3e-3}));
  ReadingOptions titled;
  titled.columns = {{"force_1", "Load"}};
  titled.sample_rate_Hz = 2000;
  EXPECT_EQ(said("Channel name,Load,Channel name,Input\nUnit,kN,Unit,V\n0,1,0,2\n0.1,1,0.1,2\n", titled), "read");
}

// Two lines of settings as wide as the table, set off by a blank line; a row of units behind another one takes no names' place.
TEST(Dialects, NamesStandInTheLastBlockAboveTheNumbers) {
  const std::string settings = "Logger,v1\nOperator,Miller\n\n", rows = "0,1.5\n0.5,2\n1,-3e-3\n";
  try {
    host_sim::parse_csv(settings + "Clock,Weg\n" + rows, "d.csv", rig());
    ADD_FAILURE() << "accepted";
  } catch (const host_sim::DataFileError& error) {
    EXPECT_EQ(std::string(error.what()).find("d.csv:4: has no column of time (the first is \"Clock\")"), 0u)
        << error.what();
  }
  ReadingOptions options;
  options.columns = {{"t", "#1"}, {"displacement_1", "#2"}};
  for (const char* blank : {"", "\n"}) {
    const auto record =
        host_sim::parse_csv(std::string("Clock,Weg\n") + blank + "ms,mm\n" + rows, "d.csv", rig(), options);
    EXPECT_DOUBLE_EQ(record.sample_period_s, 5e-4);
    EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{1.5e-3, 2e-3, -3e-6}));
  }
}

// The settings of an oscilloscope stand beside the first rows of its samples: the first of them is none of the names.
TEST(Dialects, SettingsBesideTheFirstRows) {
  ReadingOptions options;
  options.columns = {{"t", "4"}, {"displacement_1", "5"}};
  options.units = {{"displacement_1", "mm"}};
  const auto record = host_sim::parse_csv(
      "Record Length,2500,points,-0.002,1.5\nSample Interval,0.001,s,-0.001,2\nProbe,1,,0.000,3\n,,,0.001,4\n"
      ",,,0.002,5\n",
      "d.csv", rig(), options);
  EXPECT_DOUBLE_EQ(record.sample_period_s, 1e-3);
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{1.5e-3, 2e-3, 3e-3, 4e-3, 5e-3}));
  // trailing separators, blanks within the fields, more settings than are looked at for numbers
  std::string text;
  for (int i = 0; i < 18; ++i) text += "Setting,1.0e+00,, 0.00" + std::to_string(10 + i) + ", 1.5,\n";
  for (int i = 18; i < 30; ++i) text += ",,, 0.00" + std::to_string(10 + i) + ", 2,\n";
  options.units = {};
  const auto longer = host_sim::parse_csv(text, "d.csv", rig(), options);
  EXPECT_EQ(longer.samples(), 30u);
  EXPECT_DOUBLE_EQ(longer.find(Quantity::kDisplacement, 1)->values[17], 1.5);
}

// Latin-1 and Windows-1252 (0x80 is the euro sign): the same letters in UTF-8, and what is UTF-8 stays as it is.
TEST(Dialects, LettersOfOtherEncodingsAreToldInUtf8) {
  const std::string rows = "0,250,1\n1,500,2\n";
  for (const char* heads :
       {"t_s,displacement_1 [\xB5m],St\xF6rung \x80\n", "t_s,displacement_1 [\xC2\xB5m],St\xC3\xB6rung \xE2\x82\xAC\n",
        "t_s,displacement_1 [\xC2\xB5m],St\xF6rung \xE2\x82\xAC\n"}) {
    const auto record = host_sim::parse_csv(heads + rows, "d.csv", rig());
    ASSERT_EQ(record.notes.size(), 2u);
    EXPECT_EQ(record.notes[0], "displacement_1_m from column \"displacement_1 [\xC2\xB5m]\" in um: values times 1e-06");
    EXPECT_EQ(record.notes[1], "ignored: \"St\xC3\xB6rung \xE2\x82\xAC\"");
    EXPECT_DOUBLE_EQ(record.channels[0].values[1], 5e-4);
  }
}

// A head is told to its 40th byte at most, and to the end of a letter: "é" is its 40th and 41st.
TEST(Dialects, ALongHeadIsCutBetweenLetters) {
  const std::string before(39, 'x');
  const auto record =
      host_sim::parse_csv("t_s,displacement_1_m," + before + "\xC3\xA9\n0,1,1\n1,2,1\n", "d.csv", rig());
  EXPECT_EQ(record.notes, std::vector<std::string>{"ignored: \"" + before + "...\""});
}

// Of a hundred columns the first dozen is told, so that what to do is not lost behind them.
TEST(Dialects, ManyColumnsAreNotAllTold) {
  std::string heads = "t_s,displacement_1_m", rows[2] = {"0,1", "1,2"};
  for (int i = 1; i <= 100; ++i) {
    heads += ",Signal " + std::to_string(i);
    for (std::string& row : rows) row += ",0";
  }
  const auto record = host_sim::parse_csv(heads + "\n" + rows[0] + "\n" + rows[1] + "\n", "d.csv", rig());
  ASSERT_EQ(record.notes.size(), 1u);
  const std::string end = "\"Signal 12\" and 88 more";
  EXPECT_EQ(record.notes[0].substr(record.notes[0].size() - end.size()), end) << record.notes[0];
}

}  // namespace
