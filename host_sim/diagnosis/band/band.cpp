#include "band.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/records/median.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNearlyAll = 0.999;
constexpr double kPowerOfDisplacement = 0.9999;  // its velocity, on which friction acts, is faster
constexpr Index kHalfSmooth = 4;                 // bins to either side
constexpr double kOutside = 0.01;                // of a motion's square sum: a tenth of its amplitude, where it goes on

// Where a record is rest for the most part, the part that holds all but a hundredth of its motion's square sum; else all of it. A taper over
// the whole of a short decay takes the decay itself away.
Vec moving_part(const Vec& y) {
  const double middle = host_sim::median({y.data(), y.data() + y.size()}),
               noise = white_noise_sum(y) / static_cast<double>(y.size());
  Vec sum(y.size());
  double so_far = 0;
  for (Index i = 0; i < y.size(); ++i) sum[i] = so_far += (y[i] - middle) * (y[i] - middle) - noise;
  Index from = 0, to = y.size();
  while (from < to && sum[from] < kOutside / 2 * so_far) ++from;
  while (to > from + 1 && sum[to - 2] > (1 - kOutside / 2) * so_far) --to;
  const bool mostly_rest = so_far > 0 && 2 * (to - from) < y.size() && to - from >= kLeast;
  return mostly_rest ? Vec(y.segment(from, to - from)) : y;
}

struct NetPower {
  Vec bins;
  double length_s = 0;  // bin i: i / length_s
  double floor = 0;
};

// Power above the noise floor, which is that of the upper half of the spectrum; smoothed over 9 bins, over fewer at the ends.
NetPower net_power(const Vec& y, double step_s) {
  const size_t n = fast_length(static_cast<size_t>(y.size()));
  const Vec p = Fourier(n).forward(tapered(y.head(static_cast<Index>(n)))).cwiseAbs2();
  const double floor = host_sim::median({p.data() + p.size() / 2, p.data() + p.size()}) / kMedianOfSpread;
  NetPower net{Vec::Zero(p.size()), static_cast<double>(n) * step_s, floor};
  for (Index i = 0; i < p.size(); ++i) {
    const Index a = std::max<Index>(0, i - kHalfSmooth), b = std::min(p.size() - 1, i + kHalfSmooth);
    const double level = p.segment(a, b - a + 1).mean();
    net.bins[i] = level > 4 * floor ? level - floor : 0;
  }
  return net;
}

}  // namespace

Vec tapered(const Vec& y) {
  Vec w = y.array() - y.mean();
  for (Index i = 0; i < w.size(); ++i)
    w[i] *= (0.5 - 0.5 * std::cos(kTwoPi * static_cast<double>(i) / static_cast<double>(w.size()))) / std::sqrt(0.375);
  return w;
}

double top_frequency(const Vec& reading, double step_s, bool displacement) {
  const NetPower net = net_power(moving_part(reading), step_s);
  const double total = std::accumulate(net.bins.begin(), net.bins.end(), 0.0);
  double sum = 0;
  for (Index i = 0; i < net.bins.size(); ++i) {
    sum += net.bins[i];
    if (sum >= (displacement ? kPowerOfDisplacement : kNearlyAll) * total)
      return static_cast<double>(std::max<Index>(i, 2)) / net.length_s;
  }
  return 0.5 / step_s;
}

double slowest_above_noise(const Vec& reading, double step_s, int integrals) {
  const NetPower net = net_power(moving_part(reading), step_s);
  const auto integrated = [&](Index i) { return std::pow(static_cast<double>(i), -2 * integrals); };
  double lost = 0, noise = 0, least = 1e300;  // of the lowest bins what nine show: of fewer noise may show as much
  for (Index i = 1; i < net.bins.size(); ++i) noise += net.floor * integrated(i);
  Index best = 1;
  for (Index i = 1; i < net.bins.size(); ++i) {
    if (lost + noise < least) least = lost + noise, best = i;
    lost += net.bins[std::max(i, kHalfSmooth)] * integrated(i), noise -= net.floor * integrated(i);
  }
  return static_cast<double>(best) / net.length_s;
}

double lowest_frequency(const Vec& reading, double step_s, int integrals) {
  NetPower net = net_power(reading, step_s);
  net.bins[0] = 0;
  for (Index i = 1; i < net.bins.size(); ++i) net.bins[i] /= std::pow(static_cast<double>(i), 2 * integrals);
  const double total = net.bins.sum();
  double sum = 0;
  for (Index i = 1; i < net.bins.size(); ++i) {
    sum += net.bins[i];
    if (sum > (1 - kNearlyAll) * total) return static_cast<double>(i) / net.length_s;
  }
  return 1 / net.length_s;
}

Vec thinned(const Vec& y, int by) {
  if (by <= 1) return y;
  const Index half = 3 * by;
  Vec kernel(2 * half + 1);
  for (Index i = -half; i <= half; ++i) {
    const double t = static_cast<double>(i) / by * 0.8, s = i == 0 ? 1 : std::sin(kTwoPi / 2 * t) / (kTwoPi / 2 * t);
    kernel[i + half] =
        s * (0.54 + 0.46 * std::cos(kTwoPi / 2 * static_cast<double>(i) / static_cast<double>(half + 1)));
  }
  kernel /= kernel.sum();
  const Index count = (y.size() - 2 * half - 1) / by + 1;
  Vec out(count);
  for (Index i = 0; i < count; ++i) out[i] = kernel.dot(y.segment(i * by, 2 * half + 1));
  return out;
}

}  // namespace diagnosis::runs
