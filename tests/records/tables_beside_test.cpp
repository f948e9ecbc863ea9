// Two tables in one file, side by side, of different lengths and under the same names.
#include <gtest/gtest.h>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

const std::string kBeside =
    "Time (s),a (m/s^2),,Time (s),a (m/s^2)\n0,1,,0,4\n0.5,2,,0.25,5\n1,3,,0.5,6\n,,,0.75,7\n,,,1,8\n";

host_sim::Record parsed(const std::string& text, const host_sim::ReadingOptions::Choices& columns) {
  host_sim::ReadingOptions options;
  options.columns = columns;
  return host_sim::parse_csv(
      text, "beside.csv",
      rig_file::parse_rig("schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[link]]\nbetween = [1, 0]\n"
                          "viscous_N_s_m = \"estimate\"\n",
                          "rig.toml"),
      options);
}

std::string refusal(const std::string& text, const host_sim::ReadingOptions::Choices& columns) {
  try {
    parsed(text, columns);
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
  return "";
}

TEST(TablesBeside, EachIsTakenByItsPlace) {
  const host_sim::Record first = parsed(kBeside, {{"t", "#1"}, {"acceleration_1", "#2"}});
  EXPECT_EQ(first.channels[0].values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(first.sample_period_s, 0.5);
  ASSERT_EQ(first.notes.size(), 3u);  // which column, what is ignored, and
  EXPECT_EQ(first.notes[2], "left out: 2 rows at the end that hold nothing of it");
  const host_sim::Record second = parsed(kBeside, {{"t", "#4"}, {"acceleration_1", "#5"}});
  EXPECT_EQ(second.channels[0].values, (std::vector<double>{4, 5, 6, 7, 8}));
  EXPECT_EQ(second.sample_period_s, 0.25);
}

TEST(TablesBeside, ANameThatStandsTwiceIsRefusedWithItsPlaces) {
  EXPECT_NE(refusal(kBeside, {{"t", "Time (s)"}, {"acceleration_1", "#2"}})
                .find("has 2 columns \"Time (s)\" for t, expected one: take it by its place, t=#1 or t=#4"),
            std::string::npos);
  EXPECT_NE(refusal(kBeside, {{"t", "#6"}, {"acceleration_1", "#2"}}).find("has no column \"#6\""), std::string::npos);
}

// A spreadsheet's formulas go on below its times: a few rows, or as many as a hundredth of all.
TEST(TablesBeside, LastRowsWithoutATimeAreLeftOut) {
  for (const char* time : {"", "NA"}) {
    const host_sim::Record record =
        parsed("t_s,acceleration_1_m_s2\n0,1\n0.5,2\n1,3\n" + std::string(time) + ",4\n" + time + ",5\n", {});
    EXPECT_EQ(record.channels[0].values, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(record.notes.back(), "left out: 2 rows at the end without a time");
  }
  std::string text = "t_s,acceleration_1_m_s2\n0,1\n0.5,2\n";
  for (int i = 0; i < 11; ++i) text += ",3\n";
  EXPECT_EQ(refusal(text, {}), "beside.csv:4: its time is \"\", expected a finite number");
}

// A time that is missing between others is no end of a table.
TEST(TablesBeside, ATimeThatIsMissingBetweenOthersIsRefused) {
  EXPECT_EQ(refusal("t_s,acceleration_1_m_s2\n0,1\n,2\n1,3\n", {}),
            "beside.csv:3: its time is \"\", expected a finite number");
  EXPECT_EQ(refusal("t_s,acceleration_1_m_s2\n0,1\nNA,2\n1,3\n,4\n", {}),
            "beside.csv:3: its time is \"\", expected a finite number");
}

}  // namespace
