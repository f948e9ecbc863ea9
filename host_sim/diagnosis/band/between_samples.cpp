#include "between_samples.hpp"

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <vector>

namespace diagnosis::runs {
namespace {

constexpr double kShape = 12.26;  // of the Kaiser window: 0.1102 (120 - 8.7), Oppenheim and Schafer, for 120 dB

double kaiser(double place) {  // -1 to 1
  return boost::math::cyl_bessel_i(0, kShape * std::sqrt(std::max(0.0, 1 - place * place)));
}

}  // namespace

BetweenSamples::BetweenSamples(double share) : share_(share) {
  double sum = 0;
  for (Index i = 0; i < 2 * kReach; ++i) {
    const double away = share - static_cast<double>(i - kReach + 1);
    double& tap = tap_[static_cast<size_t>(i)];
    tap = boost::math::sinc_pi(0.5 * kTwoPi * away) * kaiser(away / kReach);
    sum += tap;
  }
  for (double& tap : tap_) tap /= sum;
}

double BetweenSamples::after(const Vec& y, Index sample) const {
  const Index first = sample - kReach + 1;
  if (first < 0 || first + 2 * kReach > y.size()) return between(y, sample, share_);
  return y.segment(first, 2 * kReach).dot(Vec::Map(tap_.data(), 2 * kReach));
}

double between(const Vec& y, Index sample, double share) {
  const Index n = y.size();
  if (n < 6) return y[std::clamp<Index>(sample, 0, n - 1)];
  const Index first = std::clamp<Index>(sample - 2, 0, n - 6);
  const double t = static_cast<double>(sample - first) + share;
  double sum = 0;
  constexpr double kDenominator[6] = {-120, 24, -12, 12, -24, 120};
  for (int i = 0; i < 6; ++i) {
    double product = 1;
    for (int j = 0; j < 6; ++j)
      if (j != i) product *= t - j;
    sum += y[first + i] * product / kDenominator[i];
  }
  return sum;
}

Vec delayed(const Vec& y, double samples) {
  const double whole = std::floor(-samples);
  const BetweenSamples earlier(-samples - whole);
  const Index shift = static_cast<Index>(whole), last = y.size() - 1;
  Vec out(y.size());
  for (Index i = 0; i <= last; ++i)
    out[i] = i + shift < 0 ? y[0] : i + shift >= last ? y[last] : earlier.after(y, i + shift);
  return out;
}

Vec finer(const Vec& y, Index per) {
  Vec out((y.size() - 1) * per + 1);
  std::vector<BetweenSamples> shares;
  for (Index j = 1; j < per; ++j) shares.emplace_back(static_cast<double>(j) / static_cast<double>(per));
  for (Index k = 0; k < y.size(); ++k) {
    out[k * per] = y[k];
    for (Index j = 1; j < per && k + 1 < y.size(); ++j)
      out[k * per + j] = shares[static_cast<size_t>(j - 1)].after(y, k);
  }
  return out;
}

}  // namespace diagnosis::runs
