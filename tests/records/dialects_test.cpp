// Every way in which people's programs write a table of numbers: each row makes its file and says what comes out of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "hal/rig_file/rig_reader.hpp"
#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/data_file_error.hpp"

namespace {

using host_sim::Quantity;
using host_sim::ReadingOptions;

// A mass (DOF 1) and a disc (DOF 2) with dampers to ground; `more` may hold [[channel]] tables.
rig_file::RigModel rig(const std::string& more = "") {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[dof]]\ninertia_kg_m2 = 1\n"
      "[[link]]\nbetween = [1, 0]\nviscous_N_s_m = \"estimate\"\n"
      "[[link]]\nbetween = [2, 0]\nviscous_N_m_s_rad = \"estimate\"\n" +
          more,
      "rig.toml");
}

std::string utf16(const std::string& ascii, bool big, bool mark) {
  std::string out = mark ? (big ? "\xFE\xFF" : "\xFF\xFE") : "";
  for (const char c : ascii) out += big ? std::string(1, '\0') + c : std::string(1, c) + '\0';
  return out;
}

std::string with_line_ends(std::string text, const std::string& end) {
  for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) text.replace(at, 1, end);
  return text;
}

const std::string kPlain = "t_s,force_1_N,displacement_1_m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n";

struct Dialect {
  const char* name;
  std::string text;
  const char* note;  // must stand in the notes; nullptr: there are none
};

// All of them are the plain table.
TEST(Dialects, AllSayTheSame) {
  const Dialect dialects[] = {
      {"plain", kPlain, nullptr},
      {"a line below the names",
       "t_s, force_1_N, displacement_1_m\n-------------\n0, 1.5, -0.25\n0.5, 2, 0.5\n1, -3e-3, 0.75\n", nullptr},
      {"a line of another sign",
       "t_s\tforce_1_N\tdisplacement_1_m\n=====\t=====\t=====\n0\t1.5\t-0.25\n0.5\t2\t0.5\n1\t-3e-3\t0.75\n", nullptr},
      {"semicolons", "t_s;force_1_N;displacement_1_m\n0;1.5;-0.25\n0.5;2;0.5\n1;-3e-3;0.75\n", nullptr},
      {"tabs", "t_s\tforce_1_N\tdisplacement_1_m\n0\t1.5\t-0.25\n0.5\t2\t0.5\n1\t-3e-3\t0.75\n", nullptr},
      {"blanks", "  t_s   force_1_N  displacement_1_m\n 0   1.5 -0.25\n0.5 2   0.5 \n1 -3e-3 0.75\n", nullptr},
      {"decimal commas", "t_s;force_1_N;displacement_1_m\n0;1,5;-0,25\n0,5;2;0,5\n1;-3e-3;0,75\n", nullptr},
      {"decimal commas, tabs", "t_s\tforce_1_N\tdisplacement_1_m\n0\t1,5\t-0,25\n0,5\t2,0\t0,5\n1\t-3E-3\t0,75\n",
       nullptr},
      {"quoted heads", "\"t_s\",\"force_1_N\",\"displacement_1_m\"\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"quoted numbers",
       "\"t_s\",\"force_1_N\",\"displacement_1_m\"\n\"0\",\"1.5\",\"-0.25\"\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"quoted decimal commas", "t_s;force_1_N;displacement_1_m\n\"0\";\"1,5\";\"-0,25\"\n0,5;2;0,5\n1;-3e-3;0,75\n",
       nullptr},
      {"comments",
       "# rig 7, 21 November\n% level 1\nt_s,force_1_N,displacement_1_m\n# start\n0,1.5,-0.25\n# "
       "knock\n0.5,2,0.5\n1,-3e-3,0.75\n# end\n",
       nullptr},
      {"names in a comment", "# t_s force_1_N displacement_1_m\n0 1.5 -0.25\n0.5 2 0.5\n1 -3e-3 0.75\n", nullptr},
      {"names in a comment, commas",
       "# run 3\n# t_s,force_1_N,displacement_1_m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"row of SI units", "t_s,force_1_N,displacement_1_m\ns,N,m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"row of units", "t_s,force_1,displacement_1\ns,kN,mm\n0,1.5e-3,-250\n0.5,2e-3,500\n1,-3e-6,750\n",
       "displacement_1_m from column \"displacement_1\" in mm: values times 0.001"},
      {"row of units in brackets", "Time;Force 1;Displacement 1\n[s];[N];[mm]\n0;1,5;-250,0\n0,5;2;500\n1;-3e-3;750\n",
       "values times 0.001"},
      {"units in heads", "Time (s),Force 1 (N),Displacement 1 (cm)\n0,1.5,-25\n0.5,2,50\n1,-3e-3,75\n",
       "values times 0.01"},
      {"units in names", "time_ms,force_1_kN,displacement_1_um\n0,1.5e-3,-0.25e6\n500,2e-3,0.5e6\n1000,-3e-6,0.75e6\n",
       "force_1_N from column \"force_1_kN\" in kN: values times 1000"},
      {"further columns",
       "t_s,date,force_1_N,displacement_1_m,temperature_C\n0,\"22.11.2026, "
       "noon\",1.5,-0.25,20\n0.5,later,2,0.5,20\n1,,-3e-3,0.75,\n",
       "ignored: \"date\", \"temperature_C\""},
      {"time behind", "force_1_N,displacement_1_m,t_s\n1.5,-0.25,0\n2,0.5,0.5\n-3e-3,0.75,1\n", nullptr},
      {"separator at line ends", "t_s;force_1_N;displacement_1_m;\n0;1.5;-0.25;\n0.5;2;0.5;\n1;-3e-3;0.75;\n", nullptr},
      {"separator at rows' ends alone", "t_s;force_1_N;displacement_1_m\n0;1.5;-0.25;\n0.5;2;0.5;\n1;-3e-3;0.75;\n",
       nullptr},
      {"a preamble",
       "Operator;Miller\nTime;12:00:07\n\nt_s;force_1_N;displacement_1_m\n0;1.5;-0.25\n0.5;2;0.5\n1;-3e-3;0.75\n",
       "passed over: 2 lines"},
      {"dates",
       "timestamp,force_1_N,displacement_1_m\n2026-03-01T23:59:59.500,1.5,-0.25\n"
       "2026-03-02T00:00:00.000Z,2,0.5\n2026-03-02 00:00:00.5,-3e-3,0.75\n",
       nullptr},
      {"dates of Europe",
       "Zeit;force_1_N;displacement_1_m\n28.02.2026 23:59:59,500;1,5;-0,25\n"
       "01.03.2026 00:00:00;2;0,5\n01.03.2026 00:00:00,500;-3e-3;0,75\n",
       nullptr},
      {"dates of America, quoted",
       "Time,force_1_N,displacement_1_m\n\"12/31/2026 23:59:59.0\",1.5,-0.25\n"
       "\"12/31/2026 23:59:59.5\",2,0.5\n\"01/01/2027 00:00:00\",-3e-3,0.75\n",
       nullptr},
      {"times of day past midnight",
       "time\tforce_1_N\tdisplacement_1_m\n23:59:59.5\t1.5\t-0.25\n0:00:00\t2\t0.5\n00:00:00.5\t-3e-3\t0.75\n",
       nullptr},
      {"twelve hours, and words behind some rows",
       "Device Serial Number: 0\nSample, Date/Time, Force 1 (N), Displacement 1 (m), Events\n"
       "1, 05/13/2022 11:59:59.500 AM, 1.5, -0.25, Start\n2, 05/13/2022 12:00:00.000 PM, 2, 0.5\n"
       "3, 05/13/2022 12:00:00.5 pm, -3e-3, 0.75, Pause, Stop\n",
       "ignored: \"Sample\", \"Events\""},
      {"words behind units, and ends without values",
       "Time (s) Run 1;Force 1 (N) Run 1;Displacement 1 (m) Run "
       "1\n-0,5;;0\n0;1,5;-0,25\n0,5;2;0,5\n1;-3e-3;0,75\n1,5;4;\n2;;\n",
       "left out: 1 rows at the start and 2 at the end without a value of force_1_N, displacement_1_m"},
      {"NaN at the ends",
       "t_s,force_1_N,displacement_1_m\n0,NaN,NaN\n0.5,1.5,-0.25\n1,2,0.5\n1.5,-3e-3,0.75\n2,nan,1\n",
       "left out: 1 rows at the start and 1 at the end"},
      {"LabVIEW",
       "LabVIEW Measurement\t\nSeparator\tTab\nTime\t10:11:12.1\n***End_of_Header***\t\n\t\nY_Unit_Label\tkN\tmm\n"
       "X_Dimension\tTime\tTime\nX0\t0.0\t0.0\n***End_of_Header***\t\t\nX_Value\tForce 1\tDisplacement 1\tComment\n"
       "0\t0.0015\t-250\n0.5\t0.002\t500\n1\t-3e-6\t750\n",
       "in kN: values times 1000"},
      {"CRLF", with_line_ends(kPlain, "\r\n"), nullptr},
      {"CR", with_line_ends(kPlain, "\r"), nullptr},
      {"UTF-8 mark", "\xEF\xBB\xBF" + kPlain, nullptr},
      {"UTF-16 little endian", utf16(kPlain, false, true), nullptr},
      {"UTF-16 big endian", utf16(kPlain, true, true), nullptr},
      {"UTF-16 without a mark", utf16(kPlain, false, false), nullptr},
      {"UTF-16 with CRLF", utf16(with_line_ends(kPlain, "\r\n"), false, true), nullptr},
  };
  for (const Dialect& dialect : dialects) {
    SCOPED_TRACE(dialect.name);
    host_sim::Record record;
    ASSERT_NO_THROW(
        try { record = host_sim::parse_csv(dialect.text, "d.csv", rig()); } catch (const std::exception& e) {
          ADD_FAILURE() << e.what();
          throw;
        });
    ASSERT_EQ(record.channels.size(), 2u);
    ASSERT_EQ(record.samples(), 3u);
    EXPECT_DOUBLE_EQ(record.sample_period_s, 0.5);
    const double force[] = {1.5, 2.0, -3e-3}, displacement[] = {-0.25, 0.5, 0.75};
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_DOUBLE_EQ(record.find(Quantity::kForce, 1)->values[i], force[i]);
      EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[i], displacement[i]);
    }
    std::string notes;
    for (const std::string& note : record.notes) notes += note + "\n";
    if (dialect.note == nullptr) {
      EXPECT_EQ(notes, "");
    } else {
      EXPECT_NE(notes.find(dialect.note), std::string::npos) << notes;
    }
  }
}

// Names that mean nothing to the rig are still told apart, as the rows below them are.
TEST(Dialects, ForeignNamesAreToldOneByOne) {
  try {
    host_sim::parse_csv("Uhr;Kraft 1 [N];Weg 1 [mm]\n0,0;1,5;2\n0,5;1,5;3\n", "d.csv", rig(), {{}, {}, {}, 2.0});
    FAIL() << "no channel is named";
  } catch (const host_sim::DataFileError& e) {
    EXPECT_NE(std::string(e.what()).find("\"Uhr\", \"Kraft 1 [N]\", \"Weg 1 [mm]\""), std::string::npos) << e.what();
  }
}

TEST(Dialects, ATimeThatIsNoClocksIsRefused) {
  for (const char* bad :
       {"25:00:00", "10:61:00", "2026-13-01T10:00:00", "10:11", "10:11:12 noon", "13:11:12 PM", "0:11:12 AM"})
    EXPECT_THROW(
        host_sim::parse_csv(std::string("t_s,force_1_N,displacement_1_m\n") + bad + ",1,2\n0.5,1,2\n", "d.csv", rig()),
        host_sim::DataFileError)
        << bad;
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

TEST(Dialects, SampleRateStandsForTheTime) {
  ReadingOptions options;
  options.sample_rate_Hz = 250.0;
  const auto without = host_sim::parse_csv("force_1_N\n1\n2\n", "d.csv", rig(), options);
  EXPECT_EQ(without.sample_period_s, 0.004);
  const auto clock = host_sim::parse_csv("Time;force_1_N\n12:00:00,10;1\n12:00:00,14;2\n", "d.csv", rig(), options);
  EXPECT_EQ(clock.find(Quantity::kForce, 1)->values, (std::vector<double>{1, 2}));
}

// 1024 Hz in milliseconds: 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 21, 22, ...
std::string rounded_times(double rate_Hz, const char* format, size_t count, size_t lost = 0) {
  std::string text = "t_s,force_1_N\n";
  for (size_t i = 0; i < count; ++i) {
    if (lost > 0 && i == lost) continue;
    char row[60];
    std::snprintf(row, sizeof row, format, static_cast<double>(i) / rate_Hz);
    text += std::string(row) + ",1\n";
  }
  return text;
}

TEST(Dialects, RoundedTimesAreEven) {
  const auto record = host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000), "d.csv", rig());
  EXPECT_NEAR(record.sample_period_s, 1.0 / 1024.0, 1e-9);
  ASSERT_EQ(record.notes.size(), 1u);
  EXPECT_NE(record.notes[0].find("times are rounded to 0.001 s"), std::string::npos);
  const auto coarse = host_sim::parse_csv(rounded_times(2048.0, "%.3f", 5000), "d.csv", rig());
  EXPECT_NEAR(coarse.sample_period_s, 1.0 / 2048.0, 1e-9);
}

// Seven significant digits at 2048 Hz: 9.999512 is followed by 10.00000 and 10.00049, steps of 0.00048 and 0.00049; single
// precision at 10 kHz: from 64 s on its numbers lie 7.6 us apart.
TEST(Dialects, TimesOfSoManyDigitsAreEven) {
  const auto digits = host_sim::parse_csv(rounded_times(2048.0, "%.7g", 50000), "d.csv", rig());
  EXPECT_NEAR(digits.sample_period_s, 1.0 / 2048.0, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(2048.0, "%.7g", 50000, 40000), "d.csv", rig()),
               host_sim::DataFileError);
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i < 50000; ++i)
    text += fmt::format("{:.17g},1\n", static_cast<double>(static_cast<float>(64.0 + 1e-4 * i)));
  EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", rig()).sample_period_s, 1e-4, 1e-9);
}

// Five significant digits up to a second and four decimals from there on, at 3000 Hz: 9.9997 s is followed by 10.0000, not
// by 10.000, and 0.0003333 s stands where 0.0003 would.
TEST(Dialects, TimesWhoseDigitsChangeAtASecondAreEven) {
  const auto written = [](size_t lost) {
    std::string text = "t_s,force_1_N\n";
    for (size_t i = 0; i < 40000; ++i) {
      const double t = static_cast<double>(i) / 3000.0;
      if (lost == 0 || i != lost) text += t < 1.0 ? fmt::format("{:.5g},1\n", t) : fmt::format("{:.4f},1\n", t);
    }
    return text;
  };
  EXPECT_NEAR(host_sim::parse_csv(written(0), "d.csv", rig()).sample_period_s, 1.0 / 3000.0, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(written(20000), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(written(200), "d.csv", rig()), host_sim::DataFileError);
}

// One time of a second among milliseconds is whole by chance: its last decimal is that of the others.
TEST(Dialects, AFewWholeTimesSayNothingOfTheirDecimals) {
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i <= 1000; ++i) text += fmt::format("{:.3f},1\n", 0.001 * i);
  EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", rig()).sample_period_s, 1e-3, 1e-12);
  std::string late;
  for (int i = 0; i <= 1000; ++i) late += fmt::format("{:.3f},1\n", 0.001 * i + (i > 500 ? 0.003 : 0.0));
  EXPECT_THROW(host_sim::parse_csv("t_s,force_1_N\n" + late, "d.csv", rig()), host_sim::DataFileError);
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

// Five digits of times up to 1.999 s would allow 199.02 ms as a place of its own decade, but there a time is late by two
// of its last decimals, where rounding gives half of one.
TEST(Dialects, ATimeAmidEvenOnesIsOffByMoreThanItsLastDecimal) {
  const auto text = [](const char* two_hundredth) {
    std::string lines = "t_s,force_1_N\n";
    for (int i = 0; i < 2000; ++i)
      lines += (i == 199 ? std::string(two_hundredth) : fmt::format("{:.3f}", 1e-3 * i)) + ",1\n";
    return lines;
  };
  EXPECT_NEAR(host_sim::parse_csv(text("0.199"), "d.csv", rig()).sample_period_s, 1e-3, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(text("0.19902"), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(text("0.1993"), "d.csv", rig()), host_sim::DataFileError);
}

// A board that samples every 10.04 ms stamps what its millisecond counter shows, and every seventh time it reads it 0.4 ms
// late: the stamps lie up to 0.56 ms before and 0.84 ms after even times.
TEST(Dialects, TimesInTicksOfAnotherClockAreEven) {
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i < 5000; ++i) {
    char row[60];
    const double late_ms = i % 7 == 3 ? 0.4 : 0.0;
    std::snprintf(row, sizeof row, "%.3f,1\n", 1e-3 * std::floor(10.04 * i + late_ms));
    text += row;
  }
  const auto record = host_sim::parse_csv(text, "d.csv", rig());
  EXPECT_NEAR(record.sample_period_s, 0.01004, 1e-8);
  // a lost sample is ten ticks, and a jitter of two ticks is none of the counter's
  const size_t row = text.find("\n", text.size() / 2), next = text.find("\n", row + 1);
  EXPECT_THROW(host_sim::parse_csv(text.substr(0, row) + text.substr(next), "d.csv", rig()), host_sim::DataFileError);
  std::string uneven = "t_s,force_1_N\n";
  for (int i = 0; i < 500; ++i) uneven += std::to_string(0.01 * i + (i % 3 == 1 ? 0.002 : 0.0)).substr(0, 5) + ",1\n";
  EXPECT_THROW(host_sim::parse_csv(uneven, "d.csv", rig()), host_sim::DataFileError);
}

TEST(Dialects, ALostSampleShowsInRoundedTimes) {
  EXPECT_THROW(host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000, 2500), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000, 40), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(2048.0, "%.3f", 5000, 2500), "d.csv", rig()), host_sim::DataFileError);
}

struct Refused {
  const char* name;
  std::string text;
  ReadingOptions options;
  const char* says;
};

ReadingOptions column(const char* channel, const char* name) {
  ReadingOptions options;
  options.columns = {{channel, name}};
  return options;
}

TEST(Dialects, RefusesWithTheReason) {
  const Refused cases[] = {
      {"shaped like a channel",
       "t_s,wobble_1_m\n0,1\n1,1\n",
       {},
       "d.csv:1: channel \"wobble_1_m\": is not a channel name"},
      {"no channel", "t_s,a,b\n0,1,2\n1,1,2\n", {}, "d.csv:1: names no channel (\"t_s\", \"a\", \"b\")"},
      {"unknown column", "t_s,a\n0,1\n1,1\n", column("force_1", "b"),
       "has no column \"b\" for force_1, expected one of \"t_s\", \"a\""},
      {"column of no channel", "t_s,a\n0,1\n1,1\n", column("wobble", "a"), "channel \"wobble\": is not a channel name"},
      {"unknown unit", "t_s,force_1 [parsec]\n0,1\n1,1\n", {}, "is in \"parsec\", which is no known unit"},
      {"wrong kind of unit", "t_s,force_1 [mm]\n0,1\n1,1\n", {}, "is in mm, expected a unit such as N for force_1_N"},
      {"name against units row",
       "t_s,force_1_N\ns,kN\n0,1\n1,1\n",
       {},
       "has the unit \"kN\", expected N as its name says"},
      {"voltage alone", "t_s,acceleration_1 [mV]\n0,1\n1,1\n", {}, "--sensitivity acceleration_1=\"100 mV/m/s2\""},
      {"two columns of one channel", "t_s,force_1_N,force_1_kN\n0,1,1\n1,1,1\n", {}, "stands twice"},
      {"mixed decimals", "t_s;force_1_N\n0;1,5\n1;1.5\n2;2,5\n", {}, "expected a finite number"},
      {"comma among points",
       "t_s;force_1_N\n0;1.5\n1;1,5\n",
       {},
       "d.csv:3: column force_1_N is \"1,5\", expected a finite number with a decimal point"},
      {"no time", "force_1_N,velocity_1_m_s\n1,2\n1,2\n", {}, "expected t_s, then channels, or --sample-rate"},
      {"a value missing amid others",
       "t_s;force_1_N;velocity_1_m_s\n0;1;\n1;1;2\n2;1;\n3;1;2\n",
       {},
       "d.csv:4: column velocity_1_m_s is \"\", expected a finite number"},
      {"no value at all", "t_s;force_1_N\n0;\n1;\n", {}, "column force_1_N is \"\", expected a finite number"},
      {"names missing", "0 1 2\n1 1 2\n", {}, "d.csv:1: holds no names of columns above its 3 columns of numbers"},
      {"no unit", "t_s,force_1\n0,1\n1,1\n", {}, "has no unit; did you mean \"force_1_N\"?"},
      {"line behind comments", "# a\nt_s,force_1_N\n0,1\n# b\n1,x\n", {}, "d.csv:5: column force_1_N is \"x\""},
      {"uneven behind comments", "t_s,force_1_N\n0,1\n1,1\n# b\n2,1\n4,1\n5,1\n6,1\n", {}, "d.csv:6: t_s steps by 2 s"},
  };
  for (const Refused& refused : cases) {
    SCOPED_TRACE(refused.name);
    try {
      host_sim::parse_csv(refused.text, "d.csv", rig(), refused.options);
      ADD_FAILURE() << "accepted";
    } catch (const host_sim::DataFileError& error) {
      EXPECT_NE(std::string(error.what()).find(refused.says), std::string::npos) << error.what();
    }
  }
}

// Without a rig file names alone say what a channel is.
TEST(Dialects, NoRigFileTakesEveryChannel) {
  const auto record = host_sim::parse_csv("t_s,angle_9_rad,force_3_N\n0,1,2\n1,1,2\n", "d.csv", rig_file::RigModel());
  EXPECT_EQ(record.channels.size(), 2u);
}

}  // namespace
