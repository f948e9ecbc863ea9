#include "host_sim/plant/instruments/smoothed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace host_sim {
namespace {

constexpr size_t kFewest = 16;
// Stiffnesses tried, by half decades: from one that passes all but the last few per cent below half the sampling rate to one that
// passes a two-hundredth of it; above, doubles no longer hold what the solution is made of.
constexpr double kLeast = 1e-2, kMost = 1e9, kRatio = 3.1622776601683795;
constexpr double kNoWayBack = 10.0;  // times the least score: from there on the motion itself is smoothed away
constexpr std::array<double, 4> kDifference = {-1.0, 3.0, -3.0, 1.0};

// A symmetric matrix of half-width 3, row by row from the diagonal to the right; factor() makes L D L^T of it in its place.
using Row = std::array<double, 4>;

// I + stiffness * D^T D, D the third difference.
std::vector<Row> penalised(size_t count, double stiffness) {
  std::vector<Row> matrix(count, Row{1.0, 0.0, 0.0, 0.0});
  for (size_t k = 0; k + 3 < count; ++k)
    for (size_t i = 0; i < 4; ++i)
      for (size_t j = i; j < 4; ++j) matrix[k + i][j - i] += stiffness * kDifference[i] * kDifference[j];
  return matrix;
}

void factor(std::vector<Row>& matrix) {
  const size_t n = matrix.size();
  for (size_t k = 0; k < n; ++k)
    for (size_t i = 1; i < 4 && k + i < n; ++i) {
      const double share = matrix[k][i] / matrix[k][0];
      for (size_t j = i; j < 4; ++j) matrix[k + i][j - i] -= share * matrix[k][j];
    }
}

std::vector<double> solved(const std::vector<Row>& factors, std::vector<double> y) {
  const size_t n = y.size();
  for (size_t k = 0; k < n; ++k)
    for (size_t i = 1; i < 4 && k + i < n; ++i) y[k + i] -= factors[k][i] / factors[k][0] * y[k];
  for (size_t k = n; k-- > 0;) {
    for (size_t i = 1; i < 4 && k + i < n; ++i) y[k] -= factors[k][i] * y[k + i];
    y[k] /= factors[k][0];
  }
  return y;
}

// The share of white noise that is kept: the mean over frequencies of 1 / (1 + stiffness w^6).
double share_kept(double stiffness) {
  constexpr int kFrequencies = 64;
  double sum = 0.0;
  for (int k = 0; k < kFrequencies; ++k) {
    const double step = 2.0 * std::sin(0.5 * M_PI * (k + 0.5) / kFrequencies);
    sum += 1.0 / (1.0 + stiffness * std::pow(step, 6));
  }
  return sum / kFrequencies;
}

}  // namespace

std::vector<double> smoothed(const std::vector<double>& values) {
  if (values.size() < kFewest) return values;
  std::vector<double> best = values;
  double least = std::numeric_limits<double>::infinity();
  for (double stiffness = kLeast; stiffness < kMost; stiffness *= kRatio) {
    std::vector<Row> matrix = penalised(values.size(), stiffness);
    factor(matrix);
    std::vector<double> series = solved(matrix, values);
    double missed = 0.0;
    for (size_t k = 0; k < values.size(); ++k) missed += (values[k] - series[k]) * (values[k] - series[k]);
    const double removed = 1.0 - share_kept(stiffness), score = missed / (removed * removed);
    if (score > kNoWayBack * least) break;
    if (score >= least) continue;
    if (stiffness > kLeast) best = std::move(series);
    least = score;
  }
  return best;
}

}  // namespace host_sim
