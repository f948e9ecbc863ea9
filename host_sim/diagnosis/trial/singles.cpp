#include "singles.hpp"

#include <algorithm>
#include <cmath>

#include "../doubts/possible.hpp"
#include "bristles.hpp"
#include "merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kPlainGain = 0.1;  // of the squared error: worth a fit though it shows in one burst alone

bool by_whole_error(const Attempt& a, const Attempt& b) { return whole_error(a) < whole_error(b); }

constexpr double kMoreThanNoise = 2;  // times the noise's share: so much left tells of a shape in a wrong valley too

// A shape's error has valleys. Where the best single leaves more than noise it is fitted from its other shapes as well.
Attempt reshaped(const Task& task, const State& now, const std::vector<Candidate>& all, const Attempt& best,
                 double noise) {
  Attempt found = best;
  if (best.candidates.size() > 1 || best.rounds || !best.state.fit.ok || whole_error(best) < kMoreThanNoise * noise)
    return found;
  std::vector<Candidate> shapes;
  for (const Candidate& c : all)
    if (c.same_place(best.candidates[0]) && c.terms.size() == 1 && c.terms[0].kind != Kind::kResonance)
      shapes.push_back(c);
  const auto of_shape = [&](size_t i) { return attempt(task, now, {shapes[i]}, {{0.0}}, kTrialSteps); };
  for (const Attempt& other : side_by_side(shapes.size(), of_shape))
    if (other.state.fit.ok && !other.rounds && by_whole_error(other, found)) found = other;
  return found;
}

}  // namespace

std::vector<Attempt> tried_singles(const Beside& b) {
  std::vector<Screened> list;
  bool dry_tried = false;  // where it holds the motion its linearisation tells little of what it brings
  for (const Screened& one : b.screen.singles) {
    const bool dry = b.all[one.candidate].terms[0].kind == Kind::kMissingCoulomb;
    if (list.size() >= kShortList && !(dry && !dry_tried)) continue;
    const double least = (b.noise < kMostlyNoise ? kByChance : kSure) * std::sqrt(static_cast<double>(b.already + 1));
    if (one.z < least && one.gain < kPlainGain) continue;
    dry_tried = dry_tried || dry;
    list.push_back(one);
  }
  const auto stands = [&](const Attempt& a) { return passes(a, b.already, b.noise) && can_stand(b.task, b.now, a); };
  std::vector<Attempt> singles = attempts(b.task, b.now, b.all, list, b.noise, 1e300, stands);
  std::sort(singles.begin(), singles.end(), by_whole_error);
  if (!singles.empty()) singles[0] = reshaped(b.task, b.now, b.all, singles[0], b.noise);
  return singles;
}

bool own_friction_does(const Beside& b, std::vector<Attempt>& singles, State& unstuck) {
  if (singles.empty() || !is_bristles(singles[0])) return false;
  const Attempt dry = without_bristles(b.task, b.now, singles[0]);
  if (!dry.state.fit.ok || clearly_better(singles[0], dry, b.noise)) return false;
  if (!dry.candidates.empty()) {
    singles.insert(singles.begin(), dry);
  } else if (whole_error(dry) < kPays) {
    unstuck = dry.state;
    return true;
  } else {
    singles.erase(singles.begin());
  }
  return false;
}

}  // namespace diagnosis::runs
