// What a model leaves: noise, or something that goes with the motion.
#include <algorithm>
#include <cmath>

#include "../fourier.hpp"
#include "choice.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kAboveMotion = 1.4;       // times its highest frequency: the band that shows noise alone
constexpr double kMedianOfSpread = 0.693;  // of an exponential law, per mean

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

}  // namespace

Left left_by(const System& system, const std::vector<Prepared>& records, const State& state) {
  Left left;
  Evaluator evaluator(system, state.model, records);
  const size_t channels = evaluator.traces(0).size();
  std::vector<std::vector<double>> rows(channels);
  WindowRun run;
  for (const Window& w : state.seen) {
    if (!evaluator.run(w, false, false, run)) return left;
    for (size_t c = 0; c < channels; ++c)
      for (Index k = 0; k < w.length; ++k) rows[c].push_back(run.residual[static_cast<Index>(c) * w.length + k]);
  }
  left.noise = Vec::Zero(static_cast<Index>(channels)), left.in_band = left.noise;
  const double step = records[0].step_s;
  double low_Hz = 1e300, top_Hz = 0;
  for (const Prepared& p : records) low_Hz = std::min(low_Hz, 0.5 / p.period_s), top_Hz = std::max(top_Hz, p.top_Hz);
  for (size_t c = 0; c < channels; ++c) {
    const size_t n = fast_length(rows[c].size());
    Vec y = Vec::Map(rows[c].data(), static_cast<Index>(n));
    const Vec p = Fourier(n).forward(y).cwiseAbs2() / static_cast<double>(n);
    const double bin = 1 / (static_cast<double>(n) * step);
    double from = kAboveMotion * top_Hz / bin;
    const Index bins = p.size();
    if (from > 0.8 * static_cast<double>(bins)) from = 0.67 * static_cast<double>(bins);
    std::vector<double> beside, inside;
    double sum = 0;
    for (Index i = 1; i < bins; ++i) {
      const double hertz = static_cast<double>(i) * bin;
      if (static_cast<double>(i) >= from) beside.push_back(p[i]);
      if (hertz >= low_Hz && hertz <= top_Hz) inside.push_back(p[i]), sum += p[i];
    }
    const double level = median(beside) / kMedianOfSpread;
    left.noise[static_cast<Index>(c)] = level;
    left.in_band[static_cast<Index>(c)] =
        inside.empty() || level <= 0 ? 1 : sum / static_cast<double>(inside.size()) / level;
  }
  return left;
}

double error_over(const Fitted& now, const Fitted& before) {
  if (!now.ok || !before.ok) return 1e300;
  return now.mean_square.cwiseQuotient(before.mean_square).mean();
}

}  // namespace diagnosis::runs
