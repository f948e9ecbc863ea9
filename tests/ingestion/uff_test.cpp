// Universal File 58: hand-written files, column by column, and what is refused.
#include <gtest/gtest.h>

#include <cstdarg>

#include "host_sim/ingestion/uff/uff_reader.hpp"
#include "tests/ingestion/rigs.hpp"

namespace {

// The one record of a file.
host_sim::Record parse_uff(std::string_view content, const std::string& file, const rig_file::RigModel& model) {
  auto records = host_sim::parse_uff(content, file, model);
  EXPECT_EQ(records.size(), 1u);
  return records.front();
}
using host_sim::Quantity;
using test_rigs::dampers;
using test_rigs::expect_says;
using test_rigs::refusal;

struct Dataset {
  int function_type = 1;
  std::string entity = "NONE";
  int node = 1, direction = 1;
  int data_type = 2;  // 2: single, 4: double, 5: complex
  int count = 3, spacing = 1;
  double start_s = 0.5, step_s = 0.001;
  int ordinate_type = 8;
  std::string unit = "m";
  std::string values = "  1.00000e+00 -2.50000e+00  3.00000e-03\n";
};

std::string columns(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string columns(const char* format, ...) {
  char line[128];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  return std::string(line) + "\n";
}

// The records of dataset 58 in their columns.
std::string text_of(const Dataset& set) {
  return "    -1\n    58\nTest\nNONE\n21-NOV-26 07:00:00\nNONE\nNONE\n" +
         columns("%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d", set.function_type, 0, 0, 0, set.entity.c_str(), set.node,
                 set.direction, "NONE", 0, 0) +
         columns("%10d%10d%10d%13.5e%13.5e%13.5e", set.data_type, set.count, set.spacing, set.start_s, set.step_s,
                 0.0) +
         columns("%10d%5d%5d%5d %-20s %-20s", 17, 0, 0, 0, "Time", "s") +
         columns("%10d%5d%5d%5d %-20s %-20s", set.ordinate_type, 0, 0, 0, "Channel", set.unit.c_str()) +
         columns("%10d%5d%5d%5d %-20s %-20s", 0, 0, 0, 0, "NONE", "NONE") +
         columns("%10d%5d%5d%5d %-20s %-20s", 0, 0, 0, 0, "NONE", "NONE") + set.values + "    -1\n";
}

TEST(Uff, ReadsOneChannel) {
  const auto record = parse_uff(text_of({}), "d.uff", dampers(1));
  ASSERT_EQ(record.channels.size(), 1u);
  EXPECT_EQ(record.channels[0].name, "displacement_1_m");
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{1.0, -2.5, 0.003}));
  EXPECT_EQ(record.start_s, 0.5);
  EXPECT_EQ(record.sample_period_s, 0.001);
}

TEST(Uff, OrdinateTypeNamesTheQuantity) {
  const auto record = parse_uff(
      text_of({1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 8}) + text_of({1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 11}) +
          text_of({1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 12}) + text_of({1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 13}),
      "d.uff", dampers(1));
  ASSERT_EQ(record.channels.size(), 4u);
  EXPECT_EQ(record.channels[1].name, "velocity_1_m_s");
  EXPECT_EQ(record.channels[2].name, "acceleration_1_m_s2");
  EXPECT_EQ(record.channels[3].name, "force_1_N");
}

// Nodes 7 and 12: sorted, 7 is DOF 1 and 12 is DOF 2, whatever their order in the file. -3 points against the DOF.
TEST(Uff, PlacesInOrderOfNodeAreTheDofs) {
  Dataset first, second;
  first.node = 12;
  second.node = 7;
  second.direction = -3;
  const auto record = parse_uff(text_of(first) + text_of(second), "d.uff", dampers(2));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 2)->values[0], 1.0);
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{-1.0, 2.5, -0.003}));
}

TEST(Uff, TwoDirectionsOfANodeAreTwoDofs) {
  Dataset x, z;
  x.direction = 1;
  z.direction = 3;
  z.values = "  7.0 8.0 9.0\n";
  const auto record = parse_uff(text_of(z) + text_of(x), "d.uff", dampers(2));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values[0], 1.0);
  EXPECT_EQ(record.find(Quantity::kDisplacement, 2)->values[0], 7.0);
}

TEST(Uff, RotationsAreAnglesAndTorques) {
  Dataset angle, torque;
  angle.direction = torque.direction = 6;
  torque.ordinate_type = 13;
  const auto record = parse_uff(text_of(angle) + text_of(torque), "d.uff", dampers(0, 1));
  EXPECT_EQ(record.channels[0].name, "angle_1_rad");
  EXPECT_EQ(record.channels[1].name, "torque_1_N_m");
}

TEST(Uff, AnEntityNamedBaseIsTheMovingBase) {
  Dataset mass, base;
  base.entity = "BASE";
  base.node = 99;
  const auto record = parse_uff(text_of(mass) + text_of(base), "d.uff",
                                dampers(1, 0, "[[link]]\nbetween = [1, \"base\"]\nstiffness_N_m = 10\n"));
  EXPECT_EQ(record.channels[1].name, "displacement_base_m");
}

// Double precision in E20.12, values that touch at a minus sign, Fortran's D, Windows line ends.
TEST(Uff, ReadsDoublePrecisionInFortransWays) {
  Dataset set;
  set.data_type = 4;
  set.values = "  1.000000000001D+00-2.000000000000E+00\n  3.000000000000E+00\n";
  std::string text = text_of(set);
  for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) text.insert(at, "\r");
  const auto record = parse_uff(text, "d.uff", dampers(1));
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{1.000000000001, -2.0, 3.0}));
}

// Units of mm and mN: a length factor of 1000 to the metre, a force factor of 1000 to the newton.
TEST(Uff, Dataset164ConvertsToSi) {
  Dataset x, force, torque;
  x.values = force.values = torque.values = "  1000.0 2000.0 -3000.0\n";
  force.ordinate_type = torque.ordinate_type = 13;
  const std::string units = "    -1\n   164\n         5mm (milli newton)          2\n" +
                            columns("%25.17E%25.17E%25.17E", 1000.0, 1000.0, 1.0) + columns("%25.17E", 273.15) +
                            "    -1\n";
  const auto record = parse_uff(units + text_of(x) + text_of(force), "d.uff", dampers(1));
  EXPECT_EQ(record.channels[0].values, (std::vector<double>{1.0, 2.0, -3.0}));
  EXPECT_EQ(record.channels[1].values, (std::vector<double>{1.0, 2.0, -3.0}));
  torque.direction = 4;
  Dataset angle;
  angle.direction = 4;
  const auto turning = parse_uff(units + text_of(angle) + text_of(torque), "d.uff", dampers(0, 1));
  EXPECT_EQ(turning.channels[0].values[0], 1.0);                         // radians carry no length
  EXPECT_EQ(turning.channels[1].values[0], 1000.0 / (1000.0 * 1000.0));  // torque: length times force
}

TEST(Uff, OtherDatasetsArePassedOver) {
  const std::string header = "    -1\n   151\nmodel\nwhatever 58\n    -1\n";
  EXPECT_EQ(parse_uff(header + text_of({}) + header, "d.uff", dampers(1)).samples(), 3u);
}

TEST(Uff, IsRecognisedByNameOrFirstLine) {
  EXPECT_TRUE(host_sim::is_uff("a.UNV", ""));
  EXPECT_TRUE(host_sim::is_uff("a.txt", "    -1  \r\n    58\n"));
  EXPECT_FALSE(host_sim::is_uff("a.csv", "t_s,force_1_N\n"));
}

// Units that stand at the ordinate: 2 g, -1.5 mm.
TEST(Uff, TheOrdinatesLabelConverts) {
  Dataset a, x;
  a.ordinate_type = 12;
  a.unit = "g";
  a.values = "  2.0 0.0 1.0\n";
  x.unit = "mm";
  x.values = "  -1.5 0.0 1.0\n";
  const auto record = parse_uff(text_of(a) + text_of(x), "d.uff", dampers(1));
  EXPECT_DOUBLE_EQ(record.channels[0].values[0], 2.0 * 9.80665);
  EXPECT_DOUBLE_EQ(record.channels[1].values[0], -1.5e-3);
  ASSERT_EQ(record.notes.size(), 2u);
  EXPECT_EQ(record.notes[0], "acceleration_1_m_s2 in g: values times 9.80665");
}

TEST(Uff, LabelAndDataset164MustAgree) {
  Dataset x;
  x.unit = "mm";
  const auto units = [](double length) {
    return "    -1\n   164\n         5mm (milli newton)          2\n" +
           columns("%25.17E%25.17E%25.17E", length, 1.0, 1.0) + columns("%25.17E", 273.15) + "    -1\n";
  };
  EXPECT_DOUBLE_EQ(parse_uff(units(1000.0) + text_of(x), "d.uff", dampers(1)).channels[0].values[0], 1e-3);
  expect_says(refusal([&] { parse_uff(units(39.37) + text_of(x), "d.uff", dampers(1)); }), "dataset 164 disagree");
}

// What is no time response of a quantity of ours is named and passed over: strain, a frequency response (complex).
TEST(Uff, OtherFunctionsAreIgnoredWithANote) {
  Dataset strain, response;
  strain.ordinate_type = 3;
  response.function_type = 4;
  response.data_type = 5;
  response.spacing = 0;
  const auto record = parse_uff(text_of(strain) + text_of({}) + text_of(response), "d.uff", dampers(1));
  ASSERT_EQ(record.channels.size(), 1u);
  ASSERT_EQ(record.notes.size(), 1u);
  EXPECT_EQ(record.notes[0], "ignored: ordinate type 3 (strain), function type 4 (no time response)");
}

// What the user says beyond the file: channels have no columns with names, but quantities, units and a rate.
TEST(Uff, TakesWhatTheUserSaysOfAChannel) {
  Dataset force;
  force.ordinate_type = 13;
  const std::string text = text_of({}) + text_of(force);
  const auto read = [&](const host_sim::ReadingOptions& options) {
    return host_sim::parse_uff(text, "d.uff", dampers(1), options).front();
  };
  host_sim::ReadingOptions options;
  options.columns = {{"force_1", ""}};
  EXPECT_EQ(read(options).find(Quantity::kForce, 1), nullptr);
  EXPECT_NE(read(options).find(Quantity::kDisplacement, 1), nullptr);
  options = {};
  options.units = {{"displacement_1", "mm"}};
  const auto in_mm = read(options);
  EXPECT_DOUBLE_EQ(in_mm.find(Quantity::kDisplacement, 1)->values[1], -2.5e-3);
  EXPECT_EQ(in_mm.find(Quantity::kForce, 1)->values[1], -2.5);
  EXPECT_EQ(in_mm.notes, (std::vector<std::string>{"displacement_1_m in mm, as --unit says: values times 0.001"}));
  options = {};
  options.sample_rate_Hz = 500;
  const auto at_rate = read(options);
  EXPECT_EQ(at_rate.sample_period_s, 0.002);
  EXPECT_EQ(at_rate.start_s, 0.0);
}

TEST(Uff, RefusesOptionsThatItHasNoUseFor) {
  const auto says = [](const host_sim::ReadingOptions& options) {
    return refusal([&] { host_sim::parse_uff(text_of({}), "d.uff", dampers(1), options); });
  };
  host_sim::ReadingOptions columns, units, unknown, sensitivities, none, time;
  columns.columns = {{"displacement_1", "Chan 3"}};
  units.units = {{"displacement_1", "N"}};
  unknown.units = {{"displacement_1", "cubits"}};
  sensitivities.sensitivities = {{"displacement_1", "100 mV/m"}};
  none.units = {{"velocity_7", "mm/s"}};
  time.units = {{"t", "ms"}};
  expect_says(says(columns), "has no columns with names, as --column displacement_1=\"Chan 3\" wants one");
  expect_says(says(units), "--unit displacement_1=\"N\": expected a unit such as m");
  expect_says(says(unknown), "--unit displacement_1=\"cubits\": expected a unit such as m");
  expect_says(says(sensitivities), "--sensitivity is for columns of volts");
  expect_says(says(none), "channel \"velocity_7_m_s\"");
  expect_says(says(time), "--unit t=\"ms\": its time is in seconds");
}

// Channel by channel or run by run: the second time a channel comes, it is of the second record.
TEST(Uff, SeveralRecordsInOneFile) {
  Dataset first, second, force, other_force;
  second.values = "  7.0 8.0 9.0\n";
  force.ordinate_type = other_force.ordinate_type = 13;
  other_force.values = "  4.0 5.0 6.0\n";
  for (const std::string& text : {text_of(first) + text_of(force) + text_of(second) + text_of(other_force),
                                  text_of(first) + text_of(second) + text_of(force) + text_of(other_force)}) {
    const auto records = host_sim::parse_uff(text, "d.uff", dampers(1));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].file, "d.uff, record 1");
    EXPECT_EQ(records[0].find(Quantity::kForce, 1)->values[0], 1.0);
    EXPECT_EQ(records[1].find(Quantity::kDisplacement, 1)->values[0], 7.0);
    EXPECT_EQ(records[1].find(Quantity::kForce, 1)->values[0], 4.0);
  }
}

// Three runs of a force, of the second of which the displacement is missing: whose the second displacement is cannot be told.
TEST(Uff, ARecordThatLacksAChannelIsRefused) {
  Dataset force, motion;
  force.ordinate_type = 13;
  const std::string f = text_of(force), x = text_of(motion);
  for (const std::string& text : {f + x + f + f + x, f + f + f + x + x, x + f + f})
    expect_says(refusal([&] { host_sim::parse_uff(text, "d.uff", dampers(1)); }),
                "expected every channel in every record");
}

// 1e307 kN are more newtons than a double holds.
TEST(Uff, RefusesAValueThatItsUnitMakesInfinite) {
  Dataset force;
  force.ordinate_type = 13;
  force.unit = "kN";
  force.data_type = 4;
  force.values = "  1.0 1e307 2.0\n";
  expect_says(refusal([&] { parse_uff(text_of(force), "d.uff", dampers(1)); }), "value 2 is too large in SI units");
}

// Dataset 58b: the same eleven lines, then IEEE numbers. "    58b", byte order, format, 11 lines, bytes, four zeros:
// columns 8-13, 14-19, 20-31, 32-43, 44-49, 50-55, 56-67, 68-79.
std::string binary_of(const Dataset& set, const std::string& bytes, bool big_endian) {
  std::string text = text_of(set);
  const size_t number = text.find("    58\n"), values = text.find(set.values);
  std::string binary = text.substr(0, number) +
                       columns("%6d%c%6d%6d%12d%12d%6d%6d%12d%12d", 58, 'b', big_endian ? 2 : 1, 2, 11,
                               static_cast<int>(bytes.size()), 0, 0, 0, 0) +
                       text.substr(number + 7, values - number - 7) + bytes;
  return binary + "\n    -1\n";
}

// 1.0, -2.5, 0.15625 by hand: 3F800000, C0200000, 3E200000 in single, 3FF0..., C004..., 3FC4... in double precision.
// The byte 0A, a line end, stands inside a value of the fourth row: 2.1562500 = 400A0000.
TEST(Uff, ReadsBinaryValuesOfBothByteOrdersAndWidths) {
  using namespace std::string_literals;
  const std::string big_single = "\x3F\x80\x00\x00\xC0\x20\x00\x00\x3E\x20\x00\x00"s,
                    little_single = "\x00\x00\x80\x3F\x00\x00\x20\xC0\x00\x00\x20\x3E"s,
                    big_double = "\x3F\xF0\0\0\0\0\0\0\xC0\x04\0\0\0\0\0\0\x3F\xC4\0\0\0\0\0\0"s,
                    little_double = "\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\x04\xC0\0\0\0\0\0\0\xC4\x3F"s,
                    line_end = "\x40\x0A\x00\x00\xC0\x20\x00\x00\x3E\x20\x00\x00"s;
  Dataset single, twice;
  twice.data_type = 4;
  const std::vector<double> expected = {1.0, -2.5, 0.15625};
  EXPECT_EQ(parse_uff(binary_of(single, big_single, true), "d.uff", dampers(1)).channels[0].values, expected);
  EXPECT_EQ(parse_uff(binary_of(single, little_single, false), "d.uff", dampers(1)).channels[0].values, expected);
  EXPECT_EQ(parse_uff(binary_of(twice, big_double, true), "d.uff", dampers(1)).channels[0].values, expected);
  EXPECT_EQ(parse_uff(binary_of(twice, little_double, false), "d.uff", dampers(1)).channels[0].values, expected);
  EXPECT_EQ(parse_uff(binary_of(single, line_end, true), "d.uff", dampers(1)).channels[0].values[0], 2.15625);
  Dataset force;
  force.ordinate_type = 13;
  const std::string both =
      binary_of(single, big_single, true) + text_of(force) + binary_of(twice, big_double, true) + text_of(force);
  EXPECT_EQ(host_sim::parse_uff(both, "d.uff", dampers(1)).size(), 2u);
}

TEST(Uff, RefusesBinaryDataThatIsNotWhole) {
  using namespace std::string_literals;
  const std::string bytes = "\x3F\x80\x00\x00\xC0\x20\x00\x00\x3E\x20\x00\x00"s;
  const auto say = [](const std::string& text) { return refusal([&] { parse_uff(text, "d.uff", dampers(1)); }); };
  expect_says(say(binary_of({}, bytes.substr(0, 8), true)),
              "8 bytes of values, expected the 12 that record 7 announces");
  const std::string whole = binary_of({}, bytes, true);
  expect_says(say(whole.substr(0, whole.size() - 12)), "of 12 bytes of values");
  std::string vax = whole;
  vax.replace(vax.find("     2     2"), 12, "     2     1");
  expect_says(say(vax), "floating point format 1, expected 2 (IEEE 754)");
  expect_says(say(binary_of({}, "\x7F\xC0\x00\x00\xC0\x20\x00\x00\x3E\x20\x00\x00"s, true)),
              "value 1 is not a finite number");
}

struct Broken {
  const char* name;
  Dataset set;
  const char* says;
};

// The dataset begins on line 3 (its first identification line).
TEST(Uff, RefusesWithLineAndExpectation) {
  const Broken cases[] = {
      {"spectrum", {4}, "no channel of use, only function type 4 (no time response)"},
      {"complex", {1, "NONE", 1, 1, 5}, "d.uff:9: ordinate data type 5, expected 2 or 4"},
      {"uneven", {1, "NONE", 1, 1, 2, 3, 0}, "d.uff:9: uneven abscissa spacing"},
      {"no step", {1, "NONE", 1, 1, 2, 3, 1, 0, 0.0}, "d.uff:9: abscissa increment"},
      {"too few", {1, "NONE", 1, 1, 2, 4}, "3 values, expected the 4 that record 7 announces"},
      {"too many", {1, "NONE", 1, 1, 2, 2}, "d.uff:14: more values than the 2 announced"},
      {"strain", {1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 3}, "only ordinate type 3 (strain); expected"},
      {"text",
       {1, "NONE", 1, 1, 2, 3, 1, 0, 0.001, 8, "m", " 1.0 two 3.0\n"},
       "d.uff:14: expected numbers, found \"two 3.0\""},
      {"turning", {1, "NONE", 1, 5}, "channel \"angle_1_rad\""},
  };
  for (const Broken& broken : cases)
    expect_says(refusal([&] { parse_uff(text_of(broken.set), "d.uff", dampers(1)); }), broken.says);
}

TEST(Uff, RefusesFilesThatDoNotFitTheRig) {
  const auto say = [](const std::string& text, int masses) {
    return refusal([&] { parse_uff(text, "d.uff", dampers(masses)); });
  };
  expect_says(say(text_of({}), 2),
              "channels at the nodes 1 in direction 1, expected as many places as the rig has DOFs (2)");
  Dataset other;
  other.ordinate_type = 13;
  other.step_s = 0.002;
  expect_says(say(text_of({}) + text_of(other), 1), "another sample period than the first channel");
  expect_says(say("    -1\n   151\nx\n    -1\n", 1), "no dataset 58");
  expect_says(say("nonsense\n", 1), "d.uff:1: expected -1");
  const std::string whole = text_of({});
  expect_says(say(whole.substr(0, whole.size() - 7), 1), "the file ends, expected -1");
}

}  // namespace
