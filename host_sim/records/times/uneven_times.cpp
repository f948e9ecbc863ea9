#include "host_sim/records/times/uneven_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/times/even_times.hpp"

namespace host_sim {
namespace {

constexpr double kBursts = 0.05;  // of the rows: lone rows that are written twice are fewer

// But for their rounding.
bool are_even(const std::vector<double>& time_s) {
  if (time_s.size() < 2) return false;
  const EvenTimes rounded = even_times(time_s);
  return first_uneven(time_s) == time_s.size() || (rounded.step_s > 0.0 && !rounded.lost);
}

std::string interpolation(const std::vector<double>& time_s) {
  const double usual = median_step(time_s);
  return usual > 0.0 ? fmt::format("--resample {:.4g} interpolates", 1.0 / usual) : "";
}

// Of times that never fall: what to do where a clock was read as rows arrived, many at a time; empty where they are not so.
std::string of_arrival(const std::vector<double>& time_s) {
  size_t repeated = 0;
  for (size_t i = 1; i < time_s.size(); ++i) repeated += time_s[i] == time_s[i - 1];
  const double duration_s = time_s.back() - time_s.front();
  const bool bursts = static_cast<double>(repeated) > kBursts * static_cast<double>(time_s.size());
  if (!bursts || !(duration_s > 0)) return "";
  return fmt::format(
      "; {} of {} rows bear the time of the row before, as of a clock that is read when they arrive. Where the samples "
      "are even, --sample-rate takes them so (here {:.4g} a second on the mean)",
      repeated, time_s.size(), static_cast<double>(time_s.size() - 1) / duration_s);
}

// Of the steps that are any.
double falling_share(const std::vector<double>& time_s) {
  size_t falling = 0, steps = 0;
  for (size_t i = 1; i < time_s.size(); ++i) falling += time_s[i] < time_s[i - 1], steps += time_s[i] != time_s[i - 1];
  return steps > 0 ? static_cast<double>(falling) / static_cast<double>(steps) : 0.0;
}

constexpr double kSeldom = 0.1;  // of rows in no order every second step falls

bool falls_all_along(const std::vector<double>& time_s) { return falling_share(time_s) > 1.0 - kSeldom; }

// Times that fall by a whole recording are those of a clock that has started anew, by a row or two those of rows that are exchanged.
bool begins_anew(const std::vector<double>& time_s) {
  constexpr double kRows = 16.0;
  if (falling_share(time_s) > kSeldom) return false;
  const double usual = median_step(time_s);
  for (size_t i = 1; i < time_s.size(); ++i)
    if (time_s[i] < time_s[i - 1] && !(time_s[i - 1] - time_s[i] > kRows * usual)) return false;
  return true;
}

bool is_to_be_sorted(const std::vector<double>& time_s) {
  return !falls_all_along(time_s) && !std::is_sorted(time_s.begin(), time_s.end()) && !begins_anew(time_s);
}

// Of times that fall somewhere.
std::string of_order(const std::vector<double>& time_s, const LineOf& line_of) {
  if (is_to_be_sorted(time_s)) return "the rows are not in the order of time: sort them";
  if (falls_all_along(time_s))
    return "the times fall all along: turn the order of the rows round, or is this column no time?";
  const auto falls = std::is_sorted_until(time_s.begin(), time_s.end());
  const size_t line = line_of(static_cast<size_t>(falls - time_s.begin()));
  return fmt::format("the clock starts anew in line {}: give each recording a file of its own", line);
}

// Lone rows that bear the time of the row before: where, and what to do with all of them; empty where there are none. `even`: without
// them the steps are.
struct Twice {
  std::string where;
  bool even = false;
};
Twice of_rows_written_twice(const std::vector<double>& time_s, const LineOf& line_of) {
  constexpr size_t kNamed = 5;
  std::string lines;
  std::vector<double> once = {time_s.front()};
  size_t twice = 0;
  for (size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] != time_s[i - 1]) {
      once.push_back(time_s[i]);
    } else if (++twice <= kNamed) {
      lines += fmt::format("{}{}", lines.empty() ? "" : ", ", line_of(i));
    }
  }
  if (twice == 0) return {};
  Twice found;
  if (twice == 1)
    found.where = fmt::format(": two rows have one time (line {}); leave one of them out", lines);
  else
    found.where = fmt::format(": {} rows bear the time of the row before (lines {}{}); leave them out", twice, lines,
                              twice > kNamed ? fmt::format(" and {} more", twice - kNamed) : "");
  found.even = are_even(once);
  return found;
}

// What to do about times that fall, or were read as rows arrived; empty where they are neither.
std::string of_disorder(const std::vector<double>& time_s, const LineOf& line_of) {
  return std::is_sorted(time_s.begin(), time_s.end()) ? of_arrival(time_s) : "; " + of_order(time_s, line_of);
}

// Of rows that are to be sorted and are uneven even then.
std::string of_sorted(std::vector<double> time_s) {
  std::sort(time_s.begin(), time_s.end());
  time_s.erase(std::unique(time_s.begin(), time_s.end()), time_s.end());
  return are_even(time_s) ? "" : ", then " + interpolation(time_s);
}

}  // namespace

size_t first_uneven(const std::vector<double>& time_s) {
  const double usual = median_step(time_s);
  size_t uneven = 1;
  while (uneven < time_s.size() && usual > 0.0 &&
         std::abs(time_s[uneven] - time_s[uneven - 1] - usual) <= kStepTolerance * usual)
    ++uneven;
  return uneven;
}

std::string remedy_of_uneven(const std::vector<double>& time_s, const LineOf& line_of) {
  if (time_s.front() == time_s.back() && std::is_sorted(time_s.begin(), time_s.end()))
    return "; all times are the same: they were written with too few digits. Where the samples are even, --sample-rate "
           "takes them so";
  if (const std::string disorder = of_disorder(time_s, line_of); !disorder.empty())
    return disorder + (is_to_be_sorted(time_s) ? of_sorted(time_s) : "");
  const std::string interpolates = interpolation(time_s);
  const Twice twice = of_rows_written_twice(time_s, line_of);
  if (twice.where.empty()) return interpolates.empty() ? "" : "; " + interpolates;
  return twice.where + (twice.even || interpolates.empty() ? "" : "; then " + interpolates + " the rest");
}

std::string remedy_of_falling(const std::vector<double>& time_s, const LineOf& line_of) {
  const std::string disorder = of_disorder(time_s, line_of);
  return disorder.empty() ? of_rows_written_twice(time_s, line_of).where : disorder;
}

}  // namespace host_sim
