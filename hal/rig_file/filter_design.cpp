#include "hal/rig_file/filter_design.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rig_file {
namespace {

constexpr double kPi = 3.14159265358979323846;

double kaiser(double position, double beta) {  // -1 <= position <= 1
  const double inside = 1.0 - position * position;
  return inside < 0.0 ? 0.0 : std::cyl_bessel_i(0.0, beta * std::sqrt(inside)) / std::cyl_bessel_i(0.0, beta);
}

// Low-pass of unit gain at rest; cutoff in cycles per sample.
Impulse windowed_sinc(int half, double cutoff, double beta) {
  Impulse h(static_cast<size_t>(2 * half + 1));
  double sum = 0.0;
  for (size_t i = 0; i < h.size(); ++i) {
    const int k = static_cast<int>(i) - half;
    const double sinc = k == 0 ? 2.0 * cutoff : std::sin(2.0 * kPi * cutoff * k) / (kPi * k);
    h[i] = sinc * kaiser(k / (half + 1.0), beta);
    sum += h[i];
  }
  for (double& tap : h) tap /= sum;
  return h;
}

// Central differences of the highest order that 2 half + 1 samples give: weight of the sample k away is, without its sign,
// (half!)^2 / ((half - k)! (half + k)!) times 1 / k for the first derivative, times 2 / k^2 for the second.
double central_weight(int half, int k) {
  double weight = k % 2 == 0 ? -1.0 : 1.0;
  for (int j = 1; j <= k; ++j) weight *= static_cast<double>(half - j + 1) / (half + j);
  return weight;
}
int difference_half(Band band) { return band == Band::kWide ? 7 : 4; }

}  // namespace

Impulse low_pass(double advance, Band band) {
  return convolve(windowed_sinc(kLowPassHalf, band == Band::kWide ? 0.28 : 0.15, 3.8), shifted_all_pass(advance));
}

Impulse shifted_all_pass(double advance) {
  if (advance == 0.0) return {1.0};
  // Lagrange's polynomial through the 12 samples around the wanted instant.
  constexpr int kSide = 6;
  const int before = static_cast<int>(std::floor(advance)) - kSide + 1, after = before + 2 * kSide - 1;
  const int half = std::max(-before, after);
  Impulse h(static_cast<size_t>(2 * half + 1), 0.0);
  for (int k = before; k <= after; ++k) {
    const int at = k + half;
    double weight = 1.0;
    for (int j = before; j <= after; ++j)
      if (j != k) weight *= (advance - j) / (k - j);
    h[static_cast<size_t>(at)] = weight;
  }
  return h;
}

Impulse first_difference(Band band) {
  const int half = difference_half(band);
  Impulse h(static_cast<size_t>(2 * half + 1), 0.0);
  double* const middle = h.data() + half;
  for (int k = 1; k <= half; ++k) {
    middle[k] = central_weight(half, k) / k;
    middle[-k] = -middle[k];
  }
  return h;
}

Impulse second_difference(Band band) {
  const int half = difference_half(band);
  Impulse h(static_cast<size_t>(2 * half + 1), 0.0);
  double* const middle = h.data() + half;
  for (int k = 1; k <= half; ++k) {
    const double weight = 2.0 * central_weight(half, k) / (static_cast<double>(k) * k);
    middle[k] = middle[-k] = weight;
    middle[0] -= 2.0 * weight;
  }
  return h;
}

Impulse sum_to_integral(Band band) {
  // Adams' centred rule over [n - 1, n], the integral of the polynomial through that many samples around it; the sum runs over
  // such steps. Weights of the samples on one side, nearest first; the other side has the same.
  constexpr double kSix[] = {802.0 / 1440, -93.0 / 1440, 11.0 / 1440};
  constexpr double kTwelve[] = {91473331.0 / 159667200, -15228847.0 / 159667200, 600503.0 / 21288960,
                                -6409423.0 / 958003200, 331823.0 / 319334400,    -14797.0 / 191600640};
  const double* const weight = band == Band::kWide ? kTwelve : kSix;
  const size_t side = band == Band::kWide ? std::size(kTwelve) : std::size(kSix);
  Impulse rule(2 * side + 1, 0.0);  // the last is no sample of the rule: lengths are odd
  for (size_t k = 0; k < side; ++k) rule[side + k] = rule[side - 1 - k] = weight[k];
  return rule;
}

Impulse convolve(const Impulse& a, const Impulse& b) {
  Impulse result(a.size() + b.size() - 1, 0.0);
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

}  // namespace rig_file
