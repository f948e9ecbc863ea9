// What a model leaves: noise, or something that goes with the motion.
#include <algorithm>
#include <cmath>

#include "host_sim/records/median.hpp"
#include "leftovers.hpp"
#include "lines.hpp"
#include "most_noise.hpp"
#include "with_motion.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kAlike = 4;  // times, of power: halves of a line that noise of a 25th of it shakes differ by less
constexpr double kAboveMotion = 1.4;  // times its highest frequency: the band that shows noise alone

// What drives the rig, laid end to end as the residuals are.
std::vector<Vec> drives(const std::vector<Prepared>& records, const std::vector<Window>& windows) {
  std::vector<Vec> list;
  const size_t forces = records[0].force.size();
  for (size_t d = 0; d < forces + records[0].base.reading.size(); ++d) {
    std::vector<double> rows;
    for (const Window& w : windows) {
      const Prepared& p = records[w.record];
      const Vec& y = d < forces ? p.force[d] : p.base.reading[d - forces];
      for (Index k = 0; y.size() && k < w.length; ++k) rows.push_back(y[w.from + k]);
    }
    if (!rows.empty()) list.push_back(spectrum(rows));
  }
  return list;
}

// The mains do not die away with the motion: both halves hold as much of it.
bool lasts(const std::vector<double>& rows, double mains_Hz, double step_s) {
  double power[2] = {0, 0};
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
  for (int half = 0; half < 2; ++half) {
    const std::vector<double> own(half ? middle : rows.begin(), half ? rows.end() : middle);
    const Vec p = spectrum(own);
    const double bin_Hz = 1 / (static_cast<double>(fast_length(own.size())) * step_s);
    const Index from = std::max<Index>(1, static_cast<Index>((mains_Hz - kMainsWidth_Hz) / bin_Hz));
    for (Index i = from; i < p.size() && static_cast<double>(i - 1) * bin_Hz <= mains_Hz + kMainsWidth_Hz; ++i)
      power[half] = std::max(power[half], p[i]);
  }
  return power[0] < kAlike * power[1] && power[1] < kAlike * power[0];
}

// A channel's hum, the largest of its records': the mains are in every one of them. From one to the next its phase jumps.
Hum hum_of(const Leftovers& over, size_t channel, double step_s, const std::vector<std::vector<Vec>>& driving) {
  Hum largest;
  const std::vector<std::vector<double>> records = over.rows_by_record(channel);
  for (size_t r = 0; r < records.size(); ++r) {
    const std::vector<double>& own = records[r];
    if (own.empty()) continue;
    const Hum hum = hum_in(spectrum(own), fast_length(own.size()), step_s, driving[r]);
    if (hum.amplitude == 0 || !lasts(own, hum.hertz, step_s)) return {};
    if (hum.amplitude > largest.amplitude) largest = hum;
  }
  return largest;
}

}  // namespace

Left left_by(const System& system, const std::vector<Prepared>& records, const State& state) {
  Left left;
  Leftovers over;
  if (!leave_over(system, records, state, over)) return left;
  const std::vector<std::vector<double>>&rows = over.rows, &pushed = over.pushed;
  const size_t channels = rows.size();
  left.noise = Vec::Zero(static_cast<Index>(channels)), left.in_band = left.sensor_noise = left.noise;
  const double step = records[0].step_s;
  double low_Hz = 1e300, top_Hz = 0;
  for (const Prepared& p : records) low_Hz = std::min(low_Hz, 0.5 / p.period_s), top_Hz = std::max(top_Hz, p.top_Hz);
  const Vec most = over.massless ? Vec::Constant(static_cast<Index>(channels), 1e300) : most_noise(records);
  const std::vector<Vec> driving = drives(records, state.seen);
  std::vector<std::vector<Vec>> driving_each;  // record by record
  for (size_t r = 0; r < records.size(); ++r) {
    std::vector<Window> own;
    for (const Window& w : state.seen)
      if (w.record == r) own.push_back(w);
    driving_each.push_back(drives(records, own));
  }
  for (size_t c = 0; c < channels; ++c) {
    const size_t n = fast_length(rows[c].size());
    const Vec p = spectrum(rows[c]), by_force = spectrum(pushed[c]);
    const double bin = 1 / (static_cast<double>(n) * step);
    double from = kAboveMotion * top_Hz / bin;
    const Index bins = p.size();
    if (from > 0.8 * static_cast<double>(bins)) from = 0.67 * static_cast<double>(bins);
    std::vector<double> beside, inside;
    double sum = 0, allowed = 0;
    for (Index i = 1; i < bins; ++i) {
      const double hertz = static_cast<double>(i) * bin;
      if (static_cast<double>(i) >= from) beside.push_back(p[i]);
      if (hertz >= low_Hz && hertz <= top_Hz) inside.push_back(p[i]), sum += p[i], allowed += by_force[i];
    }
    const double level = std::min(host_sim::median(beside) / kMedianOfSpread, most[static_cast<Index>(c)]);
    double pushed_level = 0;
    for (double value : pushed[c]) pushed_level += value * value;
    const double steps = of_steps(records, c) * static_cast<double>(n) / 2;  // of all frequencies: where is not known
    allowed += std::max(level * static_cast<double>(inside.size()), steps);
    left.sensor_noise[static_cast<Index>(c)] = level;
    left.noise[static_cast<Index>(c)] = level + pushed_level / static_cast<double>(pushed[c].size());
    left.in_band[static_cast<Index>(c)] = inside.empty() || allowed <= 0 ? 1 : sum / allowed;
    // lines that the drives' noise or the steps make are no sign
    Vec made = by_force;
    if (!over.steps[c].empty()) made += spectrum(over.steps[c]);
    highest_lines(p, made, static_cast<Index>(low_Hz / bin), static_cast<Index>(top_Hz / bin), bin, driving, left);
    left.hum.push_back(hum_of(over, c, step, driving_each));
  }
  const bool may_be_noise = !over.massless && (state.fit.mean_square.array() <= most.array()).all();
  if (left.worst() > kSurelyNoise && left.line < kLine && may_be_noise)
    left.with_motion = with_motion(system, records, state), left.with_loudness = with_loudness(records, state);
  return left;
}

namespace {

bool goes_with_motion(const Left& left, double deviate) {
  return left.with_motion.z > deviate || left.with_loudness.z > deviate;
}

}  // namespace

bool beyond_noise(const Left& left) {
  if (left.foreign_line > kLine) return true;
  const bool knows_motion = goes_with_motion(left, kSure);
  return left.worst() > (left.with_motion.known || knows_motion ? kSurelyNoise : kBeyondNoise) &&
         (knows_motion || !left.with_motion.known);
}

bool may_bend_numbers(const Left& left) {
  return beyond_noise(left) || (left.worst() > kBeyondNoise && goes_with_motion(left, kByChance));
}

double noise_share(const Left& left, const Fitted& fit) {
  if (left.noise.size() == 0) return 0;
  const double beside = left.noise.cwiseQuotient(fit.mean_square).cwiseMin(1.0).mean();
  if (!left.with_motion.known) return beside;
  const double most = left.with_loudness.z > kSure ? left.with_loudness.quiet_share : 1;
  return std::max(beside, std::clamp(1 - left.with_motion.share - 2 * left.with_motion.std, 0.0, most));
}

double error_over(const Fitted& now, const Fitted& before) {
  if (!now.ok || !before.ok) return 1e300;
  return now.mean_square.cwiseQuotient(before.mean_square).mean();
}

}  // namespace diagnosis::runs
