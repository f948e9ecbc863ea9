#include "rows_outdone.hpp"

#include <algorithm>
#include <cmath>

#include "../choice/round.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"

namespace diagnosis::runs {
namespace {

// The rows have no column for these: they name what looks like them.
bool runs_alone_know(Kind kind) {
  return kind == Kind::kDeadBand || kind == Kind::kCogging || kind == Kind::kMissingGravity;
}

// What causes leave that were fitted by `with_them`, as an attempt of their own.
Attempt left_by_causes(const Choice& fitted, const std::vector<Candidate>& causes, const State& with_them) {
  Attempt own;
  own.candidates = causes, own.state = with_them;
  for (const Candidate& c : causes) own.complexity += c.complexity;
  own.error = error_over(with_them.fit, fitted.base.fit);
  own.unseen = error_over(with_them.unseen_fit, fitted.base.unseen_fit);
  return own;
}

}  // namespace

bool outdone(const Task& task, const Choice& fitted, const std::vector<Candidate>& causes, const State& with_them) {
  const State& base = fitted.base;
  const double noise = noise_share(fitted.base_left, base.fit);
  const Attempt own = left_by_causes(fitted, causes, with_them);
  const std::vector<Candidate> others =
      candidates_beside(task.system, base.model, task.records, fitted.base_left.worst() > kPlainlyLeft);
  const Screen s = screen(task.system, task.records, base.model, base.seen, base.fit, others, 0);
  // friction that falls with the rate, where friction that does not may do
  const auto simpler = [&](const Candidate& c) {
    return causes.size() == 1 && causes[0].terms[0].kind == Kind::kStribeck &&
           c.terms[0].kind == Kind::kMissingCoulomb && c.terms[0].link == causes[0].terms[0].link;
  };
  size_t tried = 0;
  return std::any_of(s.singles.begin(), s.singles.end(), [&](const Screened& one) {
    const bool alone_known = runs_alone_know(others[one.candidate].terms[0].kind),
               fewer = simpler(others[one.candidate]);
    const bool asked = alone_known || ((causes.size() > 1 || fewer) && ++tried <= kShortList);
    if (hopeless(one.gain, 1, noise) || !asked) return false;
    const Attempt other = attempt(task, base, others, one, noise);
    if (!other.state.fit.ok || !(other.z > kSure) || !unseen_agrees(other)) return false;
    if (causes.size() == 1 && !fewer) return clearly_better(other, own, noise);
    const size_t more = std::max<size_t>(1, causes.size() - 1);  // numbers
    return !clearly_better(own, other, noise) ||
           whole_error(other) < std::pow(kWorth, static_cast<double>(more)) * whole_error(own);
  });
}

}  // namespace diagnosis::runs
