#include "paired.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

// Mean over blocks of what `of(before, after)` makes of their square sums, as a normal deviate.
template <typename Of>
double deviate_over_blocks(const Fitted& before, const Fitted& after, Of of) {
  const size_t n = std::min(before.block_ss.size(), after.block_ss.size()) / kFiner;
  if (n < 2) return 0;
  double sum = 0, square = 0;
  for (size_t w = 0; w < n; ++w) {
    Vec old = Vec::Zero(before.mean_square.size()), now = old;
    for (size_t b = kFiner * w; b < kFiner * (w + 1); ++b) old += before.block_ss[b], now += after.block_ss[b];
    const double d = of(old.cwiseQuotient(before.mean_square).sum(), now.cwiseQuotient(before.mean_square).sum());
    sum += d, square += d * d;
  }
  const double mean = sum / static_cast<double>(n);
  const double variance = (square / static_cast<double>(n) - mean * mean) / (static_cast<double>(n) - 1);
  return normal_deviate(mean / std::sqrt(variance + 1e-300), static_cast<double>(n) - 1);
}

}  // namespace

double paired_z(const Fitted& before, const Fitted& after) {
  return deviate_over_blocks(before, after, [](double old, double now) { return old - now; });
}

double paired_share_z(const Fitted& before, const Fitted& after) {
  return deviate_over_blocks(before, after,
                             [](double old, double now) { return std::log((old + 1e-300) / (now + 1e-300)); });
}

Fitted all_blocks(const State& s) {
  Fitted f = s.fit;
  f.block_ss.insert(f.block_ss.end(), s.unseen_fit.block_ss.begin(), s.unseen_fit.block_ss.end());
  return f;
}

}  // namespace diagnosis::runs
