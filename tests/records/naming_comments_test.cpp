// Names of columns in a comment above the numbers: as many, more, fewer, and sentences that speak of channels.
#include <gtest/gtest.h>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

const char* const kRows = "0 1 2\n1 2 3\n2 3 4\n";

std::string told(const std::string& above) {
  try {
    const host_sim::Record record = host_sim::parse_csv(above + kRows, "d.txt", {});
    std::string text;
    for (const host_sim::Channel& channel : record.channels)
      text += channel.name + " " + std::to_string(channel.values[0]) + ", ";
    for (const std::string& note : record.notes) text += note + "; ";
    return text;
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
}

const char* const kBoth = "displacement_1_m 1.000000, velocity_1_m_s 2.000000, ";

TEST(NamingComments, AsManyNamesAsColumns) {
  for (const char* above :
       {"% t_s displacement_1_m velocity_1_m_s\n", "# columns: t_s displacement_1_m velocity_1_m_s\n",
        "# displacement_1_m is from the laser, t_s is its own clock\n# t_s displacement_1_m velocity_1_m_s\n"})
    EXPECT_EQ(told(above), kBoth) << above;
  EXPECT_EQ(told("# t_s is in seconds\n# displacement_1_m from a laser\nt_s displacement_1_m velocity_1_m_s\n"), kBoth);
}

TEST(NamingComments, MoreNamesAreTakenFromTheLeftAndSaid) {
  const std::string said = told("% t_s displacement_1_m velocity_1_m_s 1/26/2018\n");
  EXPECT_EQ(said.rfind(kBoth, 0), 0u) << said;
  EXPECT_NE(said.find("line 1 names 4 columns, the rows have 3: named from the left"), std::string::npos) << said;
}

// Which of the columns lacks a name, or which of the names a column, nobody knows.
TEST(NamingComments, OtherCountsAreRefusedAndSaid) {
  EXPECT_NE(told("% t_s displacement_1_m\n").find("the comment of line 1 has 2 words for 3 columns"), std::string::npos)
      << told("% t_s displacement_1_m\n");
  EXPECT_NE(
      told("% index t_s displacement_1_m velocity_1_m_s\n").find("the comment of line 1 has 4 words for 3 columns"),
      std::string::npos);
  EXPECT_NE(told("# displacement_1_m and t_s as recorded on bench 3\n").find("holds no names of columns above its 3"),
            std::string::npos);
  EXPECT_NE(told("t_s displacement_1_m\n").find("expected 2 numbers separated by blanks, as many as line 1 has names"),
            std::string::npos);
}

// Names that mean no channel are the user's to take: the refusal says them, and --column does.
TEST(NamingComments, WordsOfNoChannelAreListed) {
  for (const char* above :
       {"# made on bench 3 by hand\n#t u $\\theta$\n", "# 2025-12-17\n# Columnas: t u $\\theta$\n#\n"}) {
    const std::string refusal = told(above);
    EXPECT_NE(
        refusal.find("the comment of line 2 has a word for each: \"t\", \"u\", \"$\\theta$\"; where these are names, "
                     "--column takes them, as in --column t=\"t\""),
        std::string::npos)
        << refusal;
    host_sim::ReadingOptions options;
    options.columns = {{"t", "t"}, {"displacement_1_m", "u"}};
    EXPECT_EQ(host_sim::parse_csv(std::string(above) + kRows, "d.txt", {}, options).channels.size(), 1u) << above;
  }
  EXPECT_EQ(told("# one two\n# 3 4 5\n").find("a word for each"), std::string::npos);
}

}  // namespace
