// What stands in a table beside its numbers, and what a newcomer's file is told.
#include "host_sim/records/csv/text/around_values.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

const char* const kHead = "t_s,displacement_1_m\n";

// 20 rows; `cell` stands in the place of the tenth value.
std::string table(const std::string& cell = "0.25", const std::string& behind = "") {
  std::string text = kHead;
  for (int i = 0; i < 20; ++i) text += fmt::format("{},{}\n", 0.01 * i, i == 9 ? cell : fmt::format("{}", i % 7));
  return text + behind;
}

std::string told(const std::string& text) {
  try {
    const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {});
    return record.notes.empty() ? "read" : record.notes.back();
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
}

TEST(AroundValues, WordsForNoValueAreFilledAsBlanksAre) {
  for (const char* word :
       {"", "NaN", "nan", "\"NaN\"", "NA", "N/A", "null", "None", "-", "#N/A", "-nan(ind)", "1.#QNAN"}) {
    EXPECT_NE(told(table(word)).find("--resample 100 fills"), std::string::npos) << told(table(word));
    host_sim::ReadingOptions options;
    options.resample_Hz = 100.0;
    EXPECT_EQ(host_sim::parse_csv(table(word), "d.csv", {}, options).samples(), 20u) << word;
  }
  for (const char* word : {"inf", "-Inf", "#DIV/0!", "*"})
    EXPECT_NE(told(table(word)).find("left blank, --resample fills it in"), std::string::npos) << told(table(word));
  for (const char* number : {"-.5", "+1", "1e-3", "-1"}) EXPECT_EQ(told(table(number)), "read") << number;
}

TEST(AroundValues, TextBelowTheNumbersIsLeftOutAndSaid) {
  for (const char* text : {"End of measurement\n", "\n\nEnd of measurement\n", "Mean,0.1\n", "\"Mean\",3"})
    EXPECT_NE(told(table("1", text)).find("left out: 1 line of text below"), std::string::npos)
        << told(table("1", text));
  EXPECT_EQ(told(table("1", "\n# end\n")), "read");
  EXPECT_NE(told(table("1", "End\n0.2,3\n")).find("\"End\""), std::string::npos);
  EXPECT_NE(told(table("1", "\n0.2,3\n")).find("is blank"), std::string::npos);
}

TEST(AroundValues, TheNamesAgainAreASecondRecording) {
  EXPECT_NE(told(table() + table()).find("d.csv:22: holds the names of the columns again"), std::string::npos)
      << told(table() + table());
}

TEST(AroundValues, ARigFileIsNoData) {
  EXPECT_NE(told("schema = \"rig/1\"\n").find("is a rig file, which --rig takes"), std::string::npos);
}

TEST(AroundValues, TimesThatAreNoneAreToldForWhatTheyAre) {
  const auto with = [](auto time) {
    std::string text = kHead;
    for (int i = 0; i < 20; ++i) text += fmt::format("{},{}\n", time(i), i % 7);
    return told(text);
  };
  EXPECT_NE(with([](int i) { return fmt::format("{}", 1700000000000 + 10 * i); }).find("--unit t=ms"),
            std::string::npos);
  EXPECT_NE(with([](int) { return "1.7e9"; }).find("too few digits"), std::string::npos);
  EXPECT_NE(with([](int i) { return fmt::format("{}", 20 - i); }).find("fall all along"), std::string::npos);
  // 0, 13, 6, 19, 12, ...: every second step falls
  EXPECT_NE(with([](int i) { return fmt::format("{}", 13 * i % 20); }).find("sort them"), std::string::npos);
  EXPECT_NE(told("millis,displacement_1_m\n0,1\n10,2\n").find("--column t=NAME"), std::string::npos);
}

TEST(AroundValues, AMisspeltChannelIsGuessedWithoutARigFile) {
  for (const char* name : {"displacment_1_m", "disp_1_m", "Displacment_1_m"})
    EXPECT_NE(told(std::string("t_s,") + name + "\n0,1\n1,1\n").find("did you mean \"displacement_1_m\""),
              std::string::npos)
        << told(std::string("t_s,") + name + "\n0,1\n1,1\n");
  EXPECT_NE(told("t_s,acc_12_m_s2\n0,1\n1,1\n").find("\"acceleration_12_m_s2\""), std::string::npos);
}

}  // namespace
