// LabVIEW's measurement files: two headers, then names and numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

std::string header(const std::string& x_columns) {
  return "LabVIEW "
         "Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\nMulti_Headings\tNo\nX_Columns\t" +
         x_columns + "\nTime_Pref\tAbsolute\nDate\t2020/08/06\nTime\t16:58:49.09\n***End_of_Header***\t\n\t\n";
}
const char* const kOfChannels =
    "Channels\t2\t\t\nSamples\t3\t3\t\nDate\t2020/08/06\t2020/08/06\t\nTime\t16:58:49.0\t16:58:49.0\t\n"
    "Y_Unit_Label\tMeters\tmm/s\t\nX_Dimension\tTime\tTime\t\nX0\t0.0E+0\t0.0E+0\t\nDelta_X\t0.01\t0.01\t\n"
    "***End_of_Header***\t\t\t\n";

// Rows of X_Value, displacement, velocity; the times blank where the header says there are none.
std::string file(const std::string& x_columns, const std::string& names = "Displacement\tVelocity") {
  std::string text = header(x_columns) + kOfChannels + "X_Value\t" + names + "\tComment\n";
  for (int i = 0; i < 3; ++i)
    text += (x_columns == "No" ? "" : fmt::format("{}", 0.02 * i)) + fmt::format("\t{}\t{}\n", i + 1, 1000 * i);
  return text;
}

void expect_read(const host_sim::Record& record, double step_s) {
  ASSERT_EQ(record.channels.size(), 2u);
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(record.channels[1].values, (std::vector<double>{0, 1, 2}));
  EXPECT_NEAR(record.sample_period_s, step_s, 1e-12);
}

TEST(Lvm, IsReadByItsOwnNamesUnitsAndTimes) { expect_read(host_sim::parse_csv(file("One"), "d.lvm", {}), 0.02); }

TEST(Lvm, DeltaXStandsForTimesThatAreNotThere) { expect_read(host_sim::parse_csv(file("No"), "d.lvm", {}), 0.01); }

TEST(Lvm, DecimalCommasAndWindowsLineEnds) {
  for (const char* x_columns : {"One", "No"}) {
    std::string text = file(x_columns);
    std::replace(text.begin(), text.end(), '.', ',');
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    expect_read(host_sim::parse_csv(text, "d.lvm", {}), x_columns == std::string("One") ? 0.02 : 0.01);
  }
}

TEST(Lvm, NamesOfItsOwnAreChosen) {
  host_sim::ReadingOptions options;
  options.columns = {{"displacement_1", "laser"}, {"velocity_1", "geophone"}};
  expect_read(host_sim::parse_csv(file("One", "laser\tgeophone"), "d.lvm", {}, options), 0.02);
}

TEST(Lvm, ASecondSegmentIsToldForWhatItIs) {
  try {
    host_sim::parse_csv(file("One") + "\n" + kOfChannels + "X_Value\tDisplacement\tVelocity\n0\t1\t2\n", "d.lvm", {});
    ADD_FAILURE() << "taken";
  } catch (const host_sim::DataFileError& error) {
    EXPECT_NE(std::string(error.what()).find("begins a second segment"), std::string::npos) << error.what();
  }
}

}  // namespace
