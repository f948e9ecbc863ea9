// What is said beside a verdict contradicts neither it nor itself.
#include "host_sim/diagnosis/advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace diagnosis {
namespace {

bool says(const Diagnosis& d, const std::string& part) {
  const std::vector<std::string> list = advice_for(d);
  return std::any_of(list.begin(), list.end(), [&](const std::string& text) { return text.find(part) != text.npos; });
}

// chi-squared per degree of freedom: 1 is noise alone, 40 is far more
TEST(Advice, NothingBeyondNoiseIsSaidWhereOnlyNoiseIsLeft) {
  Diagnosis d;
  d.verdict = Verdict::kNone, d.baseline_misfit = 1;
  EXPECT_TRUE(says(d, "nothing beyond measurement noise: to see weaker effects"));
  d.baseline_misfit = 40;
  EXPECT_FALSE(says(d, "nothing beyond"));
  EXPECT_TRUE(says(d, "to see weaker effects"));
}

TEST(Advice, AFaintTraceIsToldBesideNone) {
  Diagnosis d;
  d.verdict = Verdict::kNone, d.baseline_misfit = 1.2, d.unknown_trace = "a tone of 18.9 Hz on dof 1";
  EXPECT_FALSE(d.leaves_noise_alone());
  EXPECT_TRUE(says(d, "looks faintly like a tone of 18.9 Hz on dof 1"));
  EXPECT_FALSE(says(d, "nothing beyond"));
}

}  // namespace
}  // namespace diagnosis
