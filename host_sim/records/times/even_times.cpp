#include "host_sim/records/times/even_times.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/median.hpp"
#include "host_sim/records/times/written_times.hpp"

namespace host_sim {

TimeLine line_through(const std::vector<double>& time_s, const std::vector<double>& index) {
  const auto n = static_cast<double>(time_s.size());
  double middle = 0.0, mean = 0.0, moment = 0.0, spread = 0.0;
  for (size_t i = 0; i < time_s.size(); ++i) middle += index[i] / n, mean += (time_s[i] - time_s[0]) / n;
  for (size_t i = 0; i < time_s.size(); ++i) {
    moment += (index[i] - middle) * (time_s[i] - time_s[0] - mean);
    spread += (index[i] - middle) * (index[i] - middle);
  }
  TimeLine line;
  line.step = moment / spread;
  line.start = time_s[0] + mean - middle * line.step;
  double squares = 0.0;
  for (size_t i = 0; i < time_s.size(); ++i) {
    const double off = time_s[i] - line.start - index[i] * line.step;
    squares += off * off;
  }
  line.rms = std::sqrt(squares / n);
  return line;
}

std::vector<double> counted(size_t samples) {
  std::vector<double> index(samples);
  for (size_t i = 0; i < samples; ++i) index[i] = static_cast<double>(i);
  return index;
}

void weights_at(const double* time_s, size_t points, double t, double* weight) {
  for (size_t j = 0; j < points; ++j) {
    weight[j] = 1.0;
    for (size_t k = 0; k < points; ++k)
      if (k != j) weight[j] *= (t - time_s[k]) / (time_s[j] - time_s[k]);
  }
}

double median_step(const std::vector<double>& time_s) {
  std::vector<double> steps(time_s.size() - 1);
  for (size_t i = 0; i < steps.size(); ++i) steps[i] = time_s[i + 1] - time_s[i];
  return median(std::move(steps));
}

namespace {

// How far from even steps times may lie, in units of their last decimal. Even times that were rounded lie within half a
// unit of a line (the line through rounded times may miss the true one by a little, so 0.6). Those of a clock that is
// read beside an even sampling, in whole ticks, lie within one. A sample that is missing throws them off by half a step.
constexpr double kRounded = 0.6, kTick = 1.0, kTicksOfAStep = 4.0;
// Where early times are finer than late ones, the line through n of them misses by what the late ones were rounded by: what
// they scatter about it, at the line's end twice that over sqrt(n), and four standard deviations of it.
constexpr double kLineError = 4.0 * 2.0;

// Steps that are all the same to the last decimal but for a few of several steps: lost samples, though a step is no four decimals. A clock
// that runs a little slower than its decimals says makes single ones too, always by one decimal and each as far from the last as the others.
constexpr double kFewLost = 0.01;  // of the steps: more are a step of their own
constexpr size_t kTellRegular = 3;

bool skips_steps(const std::vector<double>& time_s, double place_s, double usual) {
  std::vector<double> rows;
  bool by_one = true;
  for (size_t i = 1; i < time_s.size(); ++i) {
    const double steps = (time_s[i] - time_s[i - 1]) / usual, whole = std::nearbyint(steps);
    if (!(whole >= 1.0) || std::abs(steps - whole) > 1e-3) return false;
    if (whole < 2.0) continue;
    rows.push_back(static_cast<double>(i));
    by_one = by_one && std::abs((whole - 1.0) * usual - place_s) < 0.5 * place_s;
  }
  if (rows.empty() || static_cast<double>(rows.size()) > kFewLost * static_cast<double>(time_s.size())) return false;
  if (!by_one || rows.size() < kTellRegular) return true;
  const TimeLine line = line_through(rows, counted(rows.size()));
  for (size_t i = 0; i < rows.size(); ++i)
    if (std::abs(rows[i] - line.start - static_cast<double>(i) * line.step) > 1.5) return true;
  return false;
}

// Steps that are off by a whole unit of the last decimal, which rounding makes of no even step: 10 and 12 ms are none of 11. A clock that is
// read a little late every few rows makes one in eight of them.
constexpr double kWholeUnit = 0.99, kFewOff = 0.2;

bool steps_are_off(const std::vector<double>& time_s, const std::vector<double>& index, double step_s,
                   const Written& written) {
  size_t off = 0;
  for (size_t i = 1; i < time_s.size(); ++i)
    off += std::abs(time_s[i] - time_s[i - 1] - (index[i] - index[i - 1]) * step_s) >
           kWholeUnit * written.place_of(time_s[i]);
  return static_cast<double>(off) > kFewOff * static_cast<double>(time_s.size());
}

EvenTimes even_if_written(const std::vector<double>& time_s, const Written& written) {
  EvenTimes even;
  const double usual = median_step(time_s);
  if (!(written.place_s > 0.0)) return even;
  std::vector<double> index = counted(time_s.size());
  const bool shows_lost = usual >= kTicksOfAStep * written.place_s || skips_steps(time_s, written.place_s, usual);
  for (size_t i = 1; shows_lost && i < index.size(); ++i) {
    const double steps = std::round((time_s[i] - time_s[i - 1]) / usual);
    if (steps < 1.0) return even;  // two rows at one time
    index[i] = index[i - 1] + steps;
  }
  const TimeLine line = line_through(time_s, index);
  if (!(line.step > 0.0) || steps_are_off(time_s, index, line.step, written)) return even;
  const double units = shows_lost ? kTick : kRounded;
  const double of_line_s =
      written.finer_early() ? kLineError * line.rms / std::sqrt(static_cast<double>(time_s.size())) : 0.0;
  for (size_t i = 0; i < time_s.size(); ++i) {
    const double on_line_s = line.start + index[i] * line.step;
    if (std::abs(time_s[i] - on_line_s) > units * written.place_of(time_s[i]) + of_line_s) return {};
    even.time_s.push_back(on_line_s);
  }
  even.step_s = line.step, even.place_s = written.place_s;
  even.lost = index.back() + 1 > static_cast<double>(index.size());
  return even;
}

double latest_of(const std::vector<double>& time_s) {
  double latest_s = 0.0;
  for (const double t : time_s) latest_s = std::max(latest_s, std::abs(t));
  return latest_s;
}

constexpr double kCoarse_s = 1e-9;  // numbers that are further apart themselves: some months

// Counted from the first's whole second: in the decimals that are left, or as close as numbers so large are to each other.
EvenTimes even_of_calendar(const std::vector<double>& time_s, double spacing_s) {
  const double whole_s = std::floor(time_s.front());
  std::vector<double> since(time_s);
  for (double& t : since) t -= whole_s;
  EvenTimes even = even_if_written(since, in_decimals(since, latest_of(since), spacing_s));
  if (!(even.step_s > 0.0)) even = even_if_written(since, {2.0 * spacing_s, 0, {}});  // nanoseconds are rounded twice
  for (double& t : even.time_s) t += whole_s;
  return even;
}

}  // namespace

EvenTimes even_times(const std::vector<double>& time_s) {
  if (time_s.size() < 16) return {};
  const double latest_s = latest_of(time_s), spacing_s = std::nextafter(latest_s, 2.0 * latest_s) - latest_s;
  if (!(latest_s > 0.0)) return {};
  if (spacing_s > kCoarse_s && time_s.front() != 0.0) return even_of_calendar(time_s, spacing_s);
  EvenTimes even = even_if_written(time_s, in_decimals(time_s, latest_s, 0.0));
  if (!(even.step_s > 0.0)) even = even_if_written(time_s, in_single_precision(time_s, latest_s));
  return even;
}

}  // namespace host_sim
