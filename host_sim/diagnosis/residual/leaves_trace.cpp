#include "leaves_trace.hpp"

#include <algorithm>
#include <cmath>

#include "../candidates/candidates.hpp"
#include "leftovers.hpp"
#include "lines.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kByChanceOfAll = 0.01;
constexpr Index kBeside = 1;  // bins on either side that a tone between two of them may be highest in

// The highest of the bins at a frequency, over the level around.
double line_at(const std::vector<double>& rows, double hertz, double step_s) {
  const Vec power = spectrum(rows);
  const auto bin = static_cast<Index>(std::lround(hertz * step_s * static_cast<double>(fast_length(rows.size()))));
  double over = 0;
  for (Index i = std::max<Index>(1, bin - kBeside); i <= std::min(power.size() - 1, bin + kBeside); ++i)
    over = std::max(over, over_level_around(power, i));
  return over;
}

}  // namespace

// A bin of noise is t times its level with a chance of e^-t.
bool leaves_tone(const Task& task, const State& state, double hertz) {
  Leftovers over;
  if (!leave_over(task.system, task.records, state, over)) return true;
  double highest = 0;
  size_t looked_at = 0;
  for (size_t channel = 0; channel < over.rows.size(); ++channel)
    for (const std::vector<double>& own : over.rows_by_record(channel)) {
      if (own.empty()) continue;
      highest = std::max(highest, line_at(own, hertz, task.records[0].step_s));
      looked_at += 2 * kBeside + 1;
    }
  return highest > std::log(static_cast<double>(looked_at) / kByChanceOfAll);
}

bool leaves_repetition(const Task& task, const State& state, int link) {
  if (!state.fit.ok) return true;
  std::vector<Candidate> list = candidates_beside(task.system, state.model, task.records, false);
  list.erase(
      std::remove_if(list.begin(), list.end(),
                     [&](const Candidate& c) { return c.terms[0].kind != Kind::kCogging || c.terms[0].link != link; }),
      list.end());
  const Screen s = screen(task.system, task.records, state.model, state.seen, state.fit, list, 0);
  return std::any_of(s.singles.begin(), s.singles.end(), [](const Screened& one) { return one.z > kSure; });
}

}  // namespace diagnosis::runs
