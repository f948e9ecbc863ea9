#include "host_sim/records/steps/tick_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/times/even_times.hpp"
#include "host_sim/records/times/resample.hpp"

namespace host_sim {
namespace {

constexpr double kAlike = 1e-4;    // of the step: the decimals of the file
constexpr double kOneStep = 0.99;  // of the rows: others lost a tick
constexpr double kOfAMark = 0.25;  // the time of one: a row that is rounded to a whole count is off by up to a half
constexpr double kMostRows = 0.9;
constexpr size_t kPoints = 6;
constexpr double kSamplesPerTurn = 4.0;

double step_at(const std::vector<double>& values, size_t row) { return values[row] - values[row - 1]; }

double least_step(const std::vector<double>& values) {
  double step = std::fabs(step_at(values, 1));
  for (size_t i = 1; i < values.size(); ++i) step = std::min(step, std::fabs(step_at(values, i)));
  return step;
}

// How many of these a row is from the one before; 0 where that is no whole number.
double whole_steps(const std::vector<double>& values, size_t row, double step) {
  const double steps = std::fabs(step_at(values, row)) / step, whole = std::nearbyint(steps);
  return std::fabs(steps - whole) > kAlike * whole ? 0.0 : whole;
}

// From one turn to the next more than a step: to and fro over one edge is no motion.
size_t turns_of(const std::vector<double>& values) {
  size_t turns = 0, run = 1;
  for (size_t i = 2; i < values.size(); ++i, ++run)
    if ((step_at(values, i) > 0.0) != (step_at(values, i - 1) > 0.0)) {
      turns += run > 1 ? 1 : 0;
      run = 0;
    }
  return turns;
}

void require_samples_per_turn(const Record& record, double rate_Hz) {
  const std::vector<double>& values = record.channels[0].values;
  const double turns_Hz = static_cast<double>(turns_of(values)) / (record.time_s.back() - record.time_s.front());
  if (rate_Hz >= kSamplesPerTurn * turns_Hz) return;
  throw DataFileError(record.file, 0,
                      fmt::format("turns {:.3g} times a second; at {:.4g} samples a second its motion would not show, "
                                  "expected --resample {:.4g} or more",
                                  turns_Hz, rate_Hz, std::ceil(kSamplesPerTurn * turns_Hz)));
}

// Where the encoder stood at each row's instant: at the edge between its count and the one before.
std::vector<double> edges_of(const std::vector<double>& values, double step) {
  std::vector<double> edges(values.size());
  for (size_t i = 1; i < values.size(); ++i) edges[i] = values[i] - std::copysign(0.5 * step, step_at(values, i));
  return edges;
}

std::vector<double> between_edges(const Record& record, double step, size_t count, double rate_Hz) {
  const std::vector<double>&values = record.channels[0].values, &time_s = record.time_s;
  const std::vector<double> edges = edges_of(values, step);
  std::vector<double> out(count);
  size_t before = 1;  // the last tick that is not after t
  double weight[kPoints];
  for (size_t i = 0; i < count; ++i) {
    const double t = time_s[1] + static_cast<double>(i) / rate_Hz;
    while (before + 1 < time_s.size() && time_s[before + 1] <= t) ++before;
    const size_t first = std::clamp(before, kPoints / 2, time_s.size() - kPoints / 2 - 1) - (kPoints / 2 - 1);
    weights_at(&time_s[first], kPoints, t, weight);
    double value = edges[before];
    for (size_t j = 0; j < kPoints; ++j) value += weight[j] * (edges[first + j] - edges[before]);
    out[i] = std::clamp(value, values[before] - 0.5 * step, values[before] + 0.5 * step);
  }
  return out;
}

}  // namespace

bool counts_marks(const std::vector<double>& time_s, const std::vector<double>& values) {
  if (values.size() < 2 || time_s.size() != values.size()) return false;
  const double step = least_step(values);
  if (!(step > 0.0)) return false;
  size_t unlike = 0, as_long = 0;
  double marks = 0.0, a_mark_s = 0.0;  // of the row before
  bool all_single = true, one_way = true;
  for (size_t i = 1; i < values.size(); ++i) {
    const double whole = whole_steps(values, i, step);
    if (whole == 0.0) return false;
    all_single = all_single && whole == 1.0;
    one_way = one_way && (step_at(values, i) > 0.0) == (step_at(values, 1) > 0.0);
    const double now_s = (time_s[i] - time_s[i - 1]) / whole;
    if (i > 1 && whole != marks) {
      ++unlike;
      as_long += std::fabs(now_s / a_mark_s - 1.0) * std::max(whole, marks) < kOfAMark ? 1 : 0;
    }
    marks = whole, a_mark_s = now_s;
  }
  return all_single || (one_way && static_cast<double>(as_long) > kMostRows * static_cast<double>(unlike));
}

double tick_step(const Record& record) {
  if (record.channels.size() != 1 || record.time_s.size() < kFewestSamples) return 0.0;
  const std::vector<double>& values = record.channels[0].values;
  const double step = least_step(values);
  if (!(step > 0.0)) return 0.0;
  size_t single = 0, turns = 0;
  double sum = 0.0, counted = 0.0;
  for (size_t i = 1; i < values.size(); ++i) {
    const double whole = whole_steps(values, i, step);
    if (whole == 0.0) return 0.0;
    single += whole == 1.0 ? 1 : 0;
    sum += std::fabs(step_at(values, i)), counted += whole;
    if (i > 1 && (step_at(values, i) > 0.0) != (step_at(values, i - 1) > 0.0)) ++turns;
  }
  const bool ticks = static_cast<double>(single) >= kOneStep * static_cast<double>(values.size() - 1);
  return ticks && turns > 0 ? sum / counted : 0.0;
}

Record resampled_ticks(const Record& record, double step, double rate_Hz) {
  require_samples_per_turn(record, rate_Hz);
  Record out;
  out.file = record.file;
  out.start_s = record.time_s[1];
  out.sample_period_s = 1.0 / rate_Hz;
  out.left_out_before.reset();
  const size_t count = samples_at(record.file, record.time_s.back() - record.time_s[1], rate_Hz);
  const Channel& channel = record.channels[0];
  out.channels.push_back(
      {channel.name, channel.quantity, channel.dof, between_edges(record, step, count, rate_Hz), step});
  out.notes = record.notes;
  out.notes.push_back(
      fmt::format("a log of ticks: each of its {} rows is one step of {:.6g} up or down, and a pause between them no "
                  "gap; interpolated "
                  "between ticks onto {:.6g} samples a second, known to half a step: {} samples",
                  channel.values.size(), step, rate_Hz, count));
  return out;
}

}  // namespace host_sim
