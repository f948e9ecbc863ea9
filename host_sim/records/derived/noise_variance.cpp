#include "host_sim/records/derived/noise_variance.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr size_t kMostOrder = 8;  // of differences that a motion vanishes in and noise does not
constexpr size_t kFewest = 32;    // rows
constexpr size_t kMostWindows = 100000;

struct Squares {
  double sum = 0;
  size_t count = 0;
};

// Of the differences that begin at row `first`, each over the size that noise of variance 1 has in it. One row more joins the weights from
// order to order.
void add_differences(const double* x, const double* t_s, Squares (&squares)[kMostOrder + 1]) {
  double weight[kMostOrder + 1] = {1.0};
  for (size_t order = 1; order <= kMostOrder; ++order) {
    double difference = 0, norm = 0;
    weight[order] = 1.0;
    for (size_t j = 0; j < order; ++j) {
      weight[j] /= t_s[j] - t_s[order], weight[order] /= t_s[order] - t_s[j];
      difference += weight[j] * x[j], norm += weight[j] * weight[j];
    }
    difference += weight[order] * x[order], norm += weight[order] * weight[order];
    if (!std::isfinite(difference)) return;
    squares[order].sum += difference * difference / norm, ++squares[order].count;
  }
}

}  // namespace

double noise_variance(const std::vector<double>& x, const std::vector<double>& t_s) {
  if (x.size() <= kFewest || t_s.size() != x.size()) return 0.0;
  const size_t windows = x.size() - kMostOrder, stride = 1 + windows / kMostWindows;
  Squares squares[kMostOrder + 1];
  for (size_t first = 0; first < windows; first += stride) add_differences(&x[first], &t_s[first], squares);
  double least = -1;
  for (size_t order = 1; order <= kMostOrder; ++order) {
    if (squares[order].count == 0) continue;
    const double variance = squares[order].sum / static_cast<double>(squares[order].count);
    if (least < 0 || variance < least) least = variance;
  }
  return std::max(0.0, least);
}

}  // namespace host_sim
