// Matrices as they are written for programs that compute, and names of several words above them.
#include "host_sim/records/csv/text/row_ends.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/csv/csv_reader.hpp"

namespace {

std::string without(const std::string& text) {
  std::string buffer;
  return std::string(host_sim::without_row_ends(text, buffer));
}

TEST(RowEnds, SeparateNothing) {
  EXPECT_EQ(without("t x\n[ 0 1.5;\n 1 2.5;\n2 3e-1]\n"), "t x\n0 1.5\n1 2.5\n2 3e-1\n");
  EXPECT_EQ(without("0,1;\r\n1,2;\r\n2,3;\r\n"), "0,1\n1,2\n2,3\n");
  EXPECT_EQ(without("[\n0 1;\n1 2;\n];\n"), "\n0 1\n1 2\n\n");
  EXPECT_EQ(without("[0, 1]\n[1, 2]\n"), "0, 1\n1, 2\n");
}

// A semicolon within the rows or the names separates, and so does the last one then: its field is empty.
TEST(RowEnds, ThatSeparateStay) {
  for (const char* text : {"t;x\n0;1\n1;2\n", "t;x;\n0;1;\n1;2;\n", "t_s;displacement_1_m\n0;\n1;\n",
                           "t,x [mm]\n0,1\n1,2\n", "t,x\n0,[\n1,2\n", "no; numbers;\n"})
    EXPECT_EQ(without(text), text);
}

// A controller's dump: names of several words, two blanks and more between them, over a matrix in brackets.
TEST(RowEnds, OfAControllersDumpAreReadWithItsNames) {
  const std::string text =
      " Sample   Time     Commanded Pos   Encoder 2 Pos\n\n[    0    0.000     2     13;\n     1    0.500     2     "
      "14;\n"
      "     2    1.000     2     -3]\n";
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 800.0\n"
      "viscous_N_s_m = \"estimate\"\n",
      "rig.toml");
  host_sim::ReadingOptions options;
  options.columns = {{"t", "Time"}, {"displacement_1", "Encoder 2 Pos"}};
  options.units = {{"displacement_1", "mm"}};
  const host_sim::Record record = host_sim::parse_csv(text, "d.txt", rig, options);
  ASSERT_EQ(record.channels.size(), 1u);
  EXPECT_EQ(record.sample_period_s, 0.5);
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{13 * 1e-3, 14 * 1e-3, -3 * 1e-3}));
}

}  // namespace
