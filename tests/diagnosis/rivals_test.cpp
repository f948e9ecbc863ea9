// What may stand in the place of the cause that is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/diagnosis/trial/merit.hpp"
#include "one_mass.hpp"

namespace {

using namespace diagnosis;

// Left by 24 windows of one block each: 1 on the mean, and `more` with a spread of `spread` from window to window.
runs::Attempt leaving(double more, double spread) {
  runs::Attempt a;
  runs::Fitted& fit = a.state.fit;
  fit.ok = true, fit.mean_square = runs::Vec::Constant(1, 1.0);
  for (size_t w = 0; w < 24; ++w)
    for (size_t b = 0; b < runs::kFiner; ++b)
      fit.block_ss.push_back(
          runs::Vec::Constant(1, (1 + more + (w % 2 ? spread : -spread)) / static_cast<double>(runs::kFiner)));
  a.state.seen.resize(1), a.state.seen[0].length = 24;
  a.error = 1 + more, a.unseen = 1;
  return a;
}

// 24 windows, the differences 0.1 +- s: their mean's standard error is s / sqrt(23), so that s = 0.192 makes it 2.5 of them.
TEST(Rivals, TwoAndAHalfDeviatesAreClearAndNotSure) {
  const runs::Attempt best = leaving(0, 0), behind = leaving(0.1, 0.192);
  EXPECT_TRUE(runs::clearly_better(best, behind, 1.0));
  EXPECT_FALSE(runs::clearly_better(best, behind, 1.0, runs::kSure));
  const runs::Attempt far_behind = leaving(0.1, 0.1);  // 4.8, of Student's law with 23 degrees of freedom 3.9
  EXPECT_TRUE(runs::clearly_better(best, far_behind, 1.0, runs::kSure));
}

// Quadratic damping, in displacements with a third of noise: rows that take their forces from them name a damping that goes with the
// displacement, three times in eight. The right one is named, or said to be as good.
TEST(Rivals, TheRightDampingIsNotLeftOutBesideNoise) {
  int named = 0;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    one_mass::Recording recording;
    recording.samples = 5000, recording.noise_m = 1.5e-3;
    const auto quadratic_N = [](double rate_m_s) { return 40 * rate_m_s * rate_m_s; };
    const Diagnosis d = diagnose(one_mass::rig(), {one_mass::record(quadratic_N, seed, recording)}, {});
    if (d.causes.empty()) continue;
    const NamedPlace right{"quadratic_damping", "link 1-0"};
    const bool in_set = std::count(d.ambiguous_with.begin(), d.ambiguous_with.end(), right) > 0;
    EXPECT_TRUE(d.names(right.effect, right.where) || in_set) << seed << " " << d.causes[0].effect;
    ++named;
  }
  EXPECT_GE(named, 4);
}

}  // namespace
