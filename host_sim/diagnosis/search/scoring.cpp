// How well a candidate fits beside a model, and with which shape.
#include "scoring.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace diagnosis {
namespace {

constexpr double kPush = 0.15;  // of Stribeck's force

bool better(const Found& a, const Found& b) { return a.score > b.score; }

}  // namespace

Term moved(const Term& term, Axis axis, double logarithm) {
  Term t = term;
  if (axis != Axis::kSecond) t.shape *= std::exp(logarithm);
  if (axis != Axis::kFirst) t.shape2 *= std::exp(logarithm);
  return t;
}

Found Scorer::scored(const Candidate& c, const Gain& gain) const {
  Found found{c, gain, 0};
  found.score = (found.gain.chi2 - c.penalty) / std::max(1.0, (fit.chi2 - found.gain.chi2) / fit.dof);
  return found;
}

Found Scorer::along(const Found& start, Axis axis, double factor, int steps) const {
  const Term t = start.candidate.term();
  double low = -std::log(factor), high = -low;  // logarithm of what the shapes are multiplied by
  const auto keep_within = [&](double shape, const CandidateBank::Range& range) {
    low = std::max(low, std::log(range.low / shape)), high = std::min(high, std::log(range.high / shape));
  };
  if (axis != Axis::kSecond) keep_within(t.shape, bank.range(t));
  if (axis != Axis::kFirst) keep_within(t.shape2, bank.second_range(t));
  if (low >= high) return start;
  Found best = start;
  const auto left_at = [&](double p) {
    const Term to = moved(t, axis, p);
    const Found f = of(bank.reshaped(start.candidate, to.shape, to.shape2));
    if (f.gain.chi2 > best.gain.chi2) best = f;
    return -f.gain.chi2;
  };
  constexpr int kBits = 10;  // of the logarithm's range: a thousandth
  auto most = static_cast<std::uintmax_t>(steps);
  boost::math::tools::brent_find_minima(left_at, low, high, kBits, most);
  return best;
}

Found Scorer::bristles(const Found& found, double factor) const {
  Found best = along(found, Axis::kFirst, factor, 8);
  Term damped = best.candidate.term();
  if (!(damped.shape2 > 0)) damped.shape2 = bank.slide_s(damped);
  Candidate candidate = bank.again(damped, model);
  candidate.threshold = best.candidate.threshold;
  Found other = of(candidate);
  for (int round = 0; round < 3; ++round)
    for (Axis axis : {Axis::kBoth, Axis::kSecond, Axis::kFirst})
      other = along(other, axis, round == 0 ? factor : 1.4, 5);
  return other.score > best.score ? other : best;
}

// A delay is its own shape: the coefficient that fits is the next, until both agree. Only of a reading whose gain is corrected
// too it is a little less.
Found Scorer::delayed(const Found& found) const {
  const auto settled = [](const Found& f) {
    return std::abs(f.gain.coefficient - f.candidate.term().shape) < 0.1 * f.gain.std;
  };
  Found best = found;
  for (int round = 0; round < 6 && best.gain.chi2 > 0 && !settled(best); ++round)
    best = of(bank.reshaped(best.candidate, best.gain.coefficient, 0));
  const bool gain = std::any_of(model.begin(), model.end(), [&](const ActiveTerm& a) {
    return a.term.kind == Kind::kForceGain && a.term.dof == found.candidate.term().dof;
  });
  return gain ? along(best, Axis::kFirst, 1.15, 8) : best;
}

Found Scorer::refined(const Found& found) const {
  const Kind kind = found.candidate.term().kind;
  if (kind == Kind::kForceDelay) return delayed(found);
  if (!CandidateBank::has_shape(found.candidate.term())) return found;
  if (kind == Kind::kPresliding) return bristles(found, 2.2);
  if (kind != Kind::kResonance) return along(found, Axis::kFirst, kind == Kind::kEndStop ? 1.3 : 2.2, 8);
  const Term& t = found.candidate.term();
  Found best = of(bank.reshaped(found.candidate, t.shape, t.shape2));  // from frequency response to time
  best = along(best, Axis::kFirst, 1.05, 7);
  best = along(best, Axis::kSecond, 8, 5);
  return along(best, Axis::kFirst, 1.01, 5);
}

Found Scorer::polished(const Found& found) const {
  const Kind kind = found.candidate.term().kind;
  if (kind == Kind::kForceDelay) return delayed(found);
  if (kind == Kind::kPresliding) return bristles(found, 1.5);
  if (kind != Kind::kResonance) return along(found, Axis::kFirst, kind == Kind::kEndStop ? 1.06 : 1.5, 8);
  return along(along(found, Axis::kFirst, 1.01, 6), Axis::kSecond, 1.6, 5);
}

bool plausible(const std::vector<ActiveTerm>& model) {
  for (const ActiveTerm& t : model) {
    if (!t.added) continue;
    const Term& term = t.term;
    if (term.kind == Kind::kForceGain && std::abs(t.value) > 0.5) return false;
    if (term.kind == Kind::kPresliding && t.value <= 0) return false;
    for (const ActiveTerm& base : model) {
      const bool friction =
          term.kind == Kind::kStribeck && base.term.kind == Kind::kCoulomb && base.term.link == term.link;
      // friction that pushes, by more than a Stribeck velocity a little off would make it
      if (friction && !base.known && base.value < -3 * base.std - kPush * t.value) return false;
      const bool stiffness =
          term.kind == Kind::kStiffnessError && base.term.kind == Kind::kStiffness && base.term.link == term.link;
      const bool mass = term.kind == Kind::kMassError && base.term.kind == Kind::kMass && base.term.dof == term.dof;
      if ((stiffness || mass) && t.value < -0.8 * base.value) return false;
    }
  }
  return true;
}

std::vector<Found> ranked(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                          const Fit& fit, size_t refined) {
  const Scorer scorer{rows, bank, model, fit};
  std::vector<Found> best;
  const std::vector<Candidate> candidates = bank.beside(model);
  const std::vector<Gain> gains = gains_of(rows, model, fit, candidates);
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const Found found = scorer.scored(c, gains[i]);
    if (!plausible(joined(model, c, found.gain))) continue;  // a gain of -1 "explains" any force that is all unknown
    if (!best.empty() && best.back().candidate.term().same_place(c.term())) {
      if (found.score > best.back().score) best.back() = found;
    } else {
      best.push_back(found);
    }
  }
  std::sort(best.begin(), best.end(), better);
  for (size_t i = 0, done = 0; i < best.size() && done < refined; ++i) {
    if (!CandidateBank::bends(best[i].candidate.term()) || best[i].score < 0.3 * best[0].score) continue;
    best[i] = scorer.refined(best[i]);
    ++done;
  }
  std::sort(best.begin(), best.end(), better);
  return best;
}

}  // namespace diagnosis
