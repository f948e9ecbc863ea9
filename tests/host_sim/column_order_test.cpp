// What files do as they please: the order of their columns, and a force column that reads nought in a free decay.
#include <string>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;

// The rows of free_decay() with each line put together anew.
template <typename Line>
std::string rewritten(const std::string& text, const Line& line) {
  std::string out;
  for (size_t from = 0; from < text.size();) {
    const size_t end = text.find('\n', from), first = text.find(',', from), second = text.find(',', first + 1);
    out += line(text.substr(from, first - from), text.substr(first + 1, second - first - 1),
                text.substr(second + 1, end - second - 1), from == 0) +
           "\n";
    from = end + 1;
  }
  return out;
}

// A displacement that swings about 0.002 m is counted from there. In the second file it stands in the third column, where the first has
// its velocity: shifted by position, the one would have moved its rate.
TEST_F(Estimate, ColumnsInAnotherOrderAreTheSameChannels) {
  const auto off = [](const std::string& t, const std::string& x, const std::string& v, bool head) {
    return t + "," + (head ? x : std::to_string(std::stod(x) + 0.002)) + "," + v;
  };
  const std::string first = rewritten(estimate_test::free_decay(4000), off);
  workspace_.write("one.csv", first);
  workspace_.write("other.csv", rewritten(first, [](const std::string& t, const std::string& x, const std::string& v,
                                                    bool) { return t + "," + v + "," + x; }));
  const auto mixed = host_sim({"estimate", "--rig", "rig.toml", "--data", "one.csv", "other.csv", "--json", "m.json"});
  ASSERT_EQ(mixed.status, 0) << mixed.errors << mixed.output;
  EXPECT_NEAR(value(json("m.json"), "viscous[1-0]"), 1.5, 0.015) << mixed.output;
  workspace_.write("other.csv", first);
  const auto alike =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "one.csv", "other.csv", "--json", "a.json", "--anyway"});
  ASSERT_EQ(alike.status, 0) << alike.errors << alike.output;
  EXPECT_EQ(value(json("m.json"), "viscous[1-0]"), value(json("a.json"), "viscous[1-0]"));
}

// A recorder writes all its channels: a force that reads nought throughout drives nothing, and the decay's centre is its rest.
TEST_F(Estimate, AForceOfNoughtsIsNoDrive) {
  const auto with = [](const std::string& t, const std::string& x, const std::string&, bool head) {
    return t + (head ? ",force_1_N," + x : ",0.0," + std::to_string(std::stod(x) + 0.0005));
  };
  const auto without = [](const std::string& t, const std::string& x, const std::string&, bool head) {
    return t + "," + (head ? x : std::to_string(std::stod(x) + 0.0005));
  };
  workspace_.write("with.csv", rewritten(estimate_test::free_decay(8000), with));
  workspace_.write("without.csv", rewritten(estimate_test::free_decay(8000), without));
  for (const char* file : {"with", "without"}) {
    const auto result = host_sim(
        {"estimate", "--rig", "rig.toml", "--data", std::string(file) + ".csv", "--json", std::string(file) + ".json"});
    ASSERT_EQ(result.status, 0) << file << ": " << result.errors << result.output;
    EXPECT_NE(result.output.find("swings about 0.0005"), std::string::npos) << file << ": " << result.output;
    EXPECT_NE(result.output.find("VALID"), std::string::npos) << file << ": " << result.output;
  }
  EXPECT_EQ(value(json("with.json"), "viscous[1-0]"), value(json("without.json"), "viscous[1-0]"));
  EXPECT_NEAR(value(json("with.json"), "viscous[1-0]"), 1.5, 0.03);
}

}  // namespace
