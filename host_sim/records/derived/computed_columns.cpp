#include "host_sim/records/derived/computed_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/records/derived/noise_variance.hpp"
#include "host_sim/records/derived/of_rounding.hpp"

namespace host_sim {
namespace {

constexpr size_t kFewest = 64;  // rows to tell it from

using Values = std::vector<double>;

// Instants of the rows, s.
Values times_of(const Record& record) {
  if (!record.time_s.empty()) return record.time_s;
  Values times(record.samples());
  for (size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) * record.sample_period_s;
  return times;
}

double mean_square(const Values& x, size_t margin) {
  double sum = 0;
  size_t count = 0;
  for (size_t i = margin; i + margin < x.size(); ++i)
    if (std::isfinite(x[i])) sum += x[i] * x[i], ++count;
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

enum class Rule { kCentral, kForward, kBackward };
constexpr Rule kRules[] = {Rule::kCentral, Rule::kForward, Rule::kBackward};

// Slope of x at its rows, 0 at the ends; the central one weighs uneven steps as a parabola does.
Values slope(const Values& x, const Values& t, Rule rule) {
  Values y(x.size(), 0.0);
  for (size_t i = 1; i + 1 < x.size(); ++i) {
    const double before = t[i] - t[i - 1], behind = t[i + 1] - t[i];
    const double backward = (x[i] - x[i - 1]) / before, forward = (x[i + 1] - x[i]) / behind;
    y[i] = rule == Rule::kForward    ? forward
           : rule == Rule::kBackward ? backward
                                     : (before * forward + behind * backward) / (before + behind);
  }
  return y;
}

// Of a slope of white noise, over that of the noise.
double slope_gain(Rule rule, double step_s) { return (rule == Rule::kCentral ? 0.5 : 2.0) / (step_s * step_s); }

// Whether one is the other but for less than the noise that it would have to have of its own.
bool is_same(const Values& one, const Values& other, double noise, size_t margin) {
  Values off(one.size());
  for (size_t i = 0; i < off.size(); ++i) off[i] = one[i] - other[i];
  return noise > 0 && mean_square(off, margin) < kOwn * kOwn * noise;
}

// What a column is of another; empty: nothing that is known here.
std::string slope_of(const Values& column, const Values& of, const Values& t, double step_s, double variance) {
  constexpr const char* kWords[] = {"central differences", "forward differences", "backward differences"};
  for (size_t r = 0; r < std::size(kRules); ++r)
    if (is_same(column, slope(of, t, kRules[r]), variance * slope_gain(kRules[r], step_s), 2)) return kWords[r];
  return "";
}

std::string second_slope_of(const Values& column, const Values& of, const Values& t, double step_s, double variance) {
  const double fourth = step_s * step_s * step_s * step_s;
  Values second(of.size(), 0.0);  // of neighbours: 1, -2, 1
  const Values forward = slope(of, t, Rule::kForward), backward = slope(of, t, Rule::kBackward);
  for (size_t i = 1; i + 1 < of.size(); ++i) second[i] = 2 * (forward[i] - backward[i]) / (t[i + 1] - t[i - 1]);
  if (is_same(column, second, 6 * variance / fourth, 3)) return "second differences";
  // central differences twice: 1/4, 0, -1/2, 0, 1/4
  if (is_same(column, slope(slope(of, t, Rule::kCentral), t, Rule::kCentral), 0.375 * variance / fourth, 3))
    return "central differences, twice";
  return "";
}

// Whether a column's steps are the other's areas: trapezia, or rectangles. Of the trapezia the mean of two neighbours' noise.
std::string sum_of(const Values& column, const Values& of, const Values& t, double variance) {
  const Values steps = slope(column, t, Rule::kBackward);
  Values trapezia(of.size(), 0.0), rectangles(of.size(), 0.0);
  for (size_t i = 1; i < of.size(); ++i) trapezia[i] = 0.5 * (of[i] + of[i - 1]), rectangles[i] = of[i - 1];
  if (is_same(steps, trapezia, 0.5 * variance, 2)) return "sums of trapezia";
  if (is_same(steps, rectangles, variance, 2) || is_same(steps, of, variance, 2)) return "sums";
  return "";
}

struct Computed {
  const Channel* column;
  const Channel* of;
  std::string how;
};

std::optional<Computed> computed_of(const Channel& column, const Channel& of, const Values& t, double step_s) {
  const int orders = static_cast<int>(column.quantity) - static_cast<int>(of.quantity);
  if (column.dof != of.dof || orders == 0) return {};
  const double variance = noise_variance(of.values, t);
  const std::string how = orders == 1    ? slope_of(column.values, of.values, t, step_s, variance)
                          : orders == 2  ? second_slope_of(column.values, of.values, t, step_s, variance)
                          : orders == -1 ? sum_of(column.values, of.values, t, variance)
                                         : "";
  if (how.empty() && orders > 0 && follows_rounding(column, of, t))
    return Computed{&column, &of, "out of the steps in which that is read, which no sensor of its own knows"};
  return how.empty() ? std::nullopt : std::optional<Computed>(Computed{&column, &of, how});
}

// The first of the record that is computed from another one. Forward differences of a displacement and sums of a velocity are the same
// two columns: they are taken for the differences.
std::optional<Computed> first_computed(const Record& record, const Values& t, double step_s) {
  for (const bool sums : {false, true})
    for (const Channel& column : record.channels)
      for (const Channel& of : record.channels)
        if (column.quantity != Quantity::kForce && of.quantity != Quantity::kForce &&
            sums == (column.quantity < of.quantity))
          if (auto found = computed_of(column, of, t, step_s)) return found;
  return {};
}

}  // namespace

void leave_out_computed(Record& record) {
  if (record.samples() < kFewest) return;
  const Values t = times_of(record);
  for (size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1])) return;
  const double step_s = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  while (const auto found = first_computed(record, t, step_s)) {
    record.notes.push_back(fmt::format("{}: was computed from {} ({}) and measures nothing of its own: left out",
                                       found->column->name, found->of->name, found->how));
    record.computed.push_back(found->column->name);
    record.channels.erase(record.channels.begin() + (found->column - record.channels.data()));
  }
}

}  // namespace host_sim
