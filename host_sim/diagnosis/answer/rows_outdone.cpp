#include "rows_outdone.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "../choice/round.hpp"
#include "../numbers/numbers_of.hpp"
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

namespace {

// Of the rms motion: what goes with its third power is then off by 3 * 0.2^2 = 12 %, as much as tells it from the second.
constexpr double kMuchNoise = 0.2;

// rms noise over rms motion, of each DOF's quietest channel; the largest.
double noise_of_motion(const Task& task, const Left& left) {
  const std::vector<MotionTrace>& traces = task.records[0].traces;
  std::map<int, double> of_dof;
  for (size_t c = 0; c < traces.size() && static_cast<Index>(c) < left.sensor_noise.size(); ++c) {
    double square = 0, samples = 0;
    for (const Prepared& p : task.records)
      square += p.traces[c].y.squaredNorm(), samples += static_cast<double>(p.traces[c].y.size());
    const double share = left.sensor_noise[static_cast<Index>(c)] * samples / std::max(1e-300, square);
    const auto known = of_dof.emplace(traces[c].dof, share).first;
    known->second = std::min(known->second, share);
  }
  double most = 0;
  for (const auto& [dof, share] : of_dof) most = std::max(most, share);
  return std::sqrt(most);
}

}  // namespace

bool stands_in_noise(const Task& task, const Choice& fitted, const Candidate& cause, const State& with_it,
                     std::vector<NamedPlace>& as_good) {
  if (cause.terms[0].link < 0 || noise_of_motion(task, fitted.base_left) < kMuchNoise) return true;
  Choice runs = fitted;
  runs.named = {Named{cause, kNamed, 1.0, {}, true}}, runs.final = with_it;
  weigh_rivals(
      task, [](double) {}, runs);
  const Named& named = runs.named[0];
  for (const Rival& r : named.rivals) as_good.push_back(named_place(task, r.candidate.terms[0]));
  return named.candidate.same_place(cause);
}

}  // namespace diagnosis::runs
