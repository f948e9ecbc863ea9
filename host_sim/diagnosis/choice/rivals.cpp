#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "../doubts/possible.hpp"
#include "../doubts/unresolved_mode.hpp"
#include "../numbers/numbers_of.hpp"
#include "../trial/attempt.hpp"
#include "../trial/bristles.hpp"
#include "../trial/merit.hpp"
#include "round.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kRivalsTried = 6;
// Where some fall behind by more than two deviations: of a set of four one can still be told.
constexpr size_t kMostBeside = 3;
constexpr double kMuchWorse = 4;  // of a screened gain's rest, against the best: not tried

// The rig as given (`base`) with every named cause but one; false where another one rests on it.
bool without(const Task& task, const Choice& choice, const State& base, size_t one, State& rest) {
  std::vector<Candidate> others;
  const int own_terms = static_cast<int>(choice.base.model.size());
  for (size_t i = 0; i < choice.named.size(); ++i) {
    if (choice.named[i].candidate.host >= own_terms) return false;
    if (i != one) others.push_back(choice.named[i].candidate);
  }
  rest = base;
  if (others.empty()) return true;
  std::vector<std::vector<double>> start;
  for (const Candidate& c : others) start.push_back(std::vector<double>(c.terms.size(), 0.0));
  rest = attempt(task, base, others, start, kBaseSteps).state;
  return rest.fit.ok;
}

// Alone it left what this one does not.
bool outdone(const Named& mine, const Candidate& other) {
  return std::any_of(mine.outdone.begin(), mine.outdone.end(), [&](const Candidate& c) { return c.same_place(other); });
}

// What channels of a DOF contradict each other in is that fault of one of them: no effect of the rig stands in its place.
bool may_stand_for(const Named& mine, const Term& other) {
  const Term& fault = mine.candidate.terms[0];
  return !mine.of_channels || (other.kind == fault.kind && other.dof == fault.dof);
}

}  // namespace

std::vector<Move> moves_between(const Task& task, const Model& rest, const Model& named, const Model& rival) {
  std::vector<Move> list;
  const std::vector<diagnosis::Parameter> beside_named = values_of(task, named), beside_rival = values_of(task, rival);
  const auto value_in = [](const std::vector<diagnosis::Parameter>& numbers, const std::string& name) {
    const auto p = std::find_if(numbers.begin(), numbers.end(), [&](const auto& o) { return o.name == name; });
    return p == numbers.end() ? std::optional<double>() : p->value;
  };
  for (const diagnosis::Parameter& p : values_of(task, rest)) {
    const auto before = value_in(beside_named, p.name), now = value_in(beside_rival, p.name);
    if (!before || !now) continue;
    const bool phase = p.name.rfind("cogging_phase[", 0) == 0;  // a turn more is the same
    list.push_back({p.name, phase ? std::remainder(*now - *before, kTwoPi) : *now - *before});
  }
  return list;
}

namespace {

// One that drives its link comes behind those that do not.
void put_drivers_behind(const Task& task, Attempt& own, std::vector<Attempt>& as_good) {
  const auto damps = [&](const Attempt& t) { return !drives_a_link(task, t.state, t.candidates); };
  const auto drivers = std::stable_partition(as_good.begin(), as_good.end(), damps);
  const bool own_drives = !damps(own);
  if (own_drives && drivers == as_good.begin()) return;
  as_good.erase(drivers, as_good.end());
  if (!own_drives) return;
  own = std::move(as_good.front());
  as_good.erase(as_good.begin());
}

// The named cause as an attempt beside the rest.
Attempt own_beside(const Task& task, const State& rest, const Choice& choice, const Named& mine) {
  Attempt own;
  own.candidates = {mine.candidate}, own.state = choice.final, own.complexity = mine.candidate.complexity;
  own.z = mine.z;
  if (rest.seen.size() != choice.final.seen.size()) own.state = on_all(task, rest, choice.final);
  own.unresolved = is_unresolved_mode(task, own.state, own.candidates);
  own.error = error_over(own.state.fit, rest.fit), own.unseen = error_over(own.state.unseen_fit, rest.unseen_fit);
  return own;
}

bool no_rival(const Task& task, const State& rest, const Attempt& a) {
  return below_nought(a.state) || cannot_be(task, rest, a) || a.unresolved;
}

// Those that the linearisation promises about as much of as of the best, fitted; of bristles dry friction in their place too.
std::vector<Attempt> rivals_tried(const Task& task, const State& rest, double noise, const Choice& choice,
                                  const Named& mine, const Attempt& own) {
  const std::vector<Candidate> all = candidates_beside(task.system, rest.model, task.records, false);
  const Screen s = screen(task.system, task.records, rest.model, rest.seen, rest.fit, all, 0);
  double best_gain = 0;
  for (const Screened& one : s.singles) best_gain = std::max(best_gain, one.gain);
  std::vector<Screened> list;
  for (const Screened& one : s.singles) {
    if (list.size() >= kRivalsTried) break;
    const bool named = std::any_of(choice.named.begin(), choice.named.end(),
                                   [&](const Named& n) { return n.candidate.same_place(all[one.candidate]); });
    if (named || outdone(mine, all[one.candidate]) || !may_stand_for(mine, all[one.candidate].terms[0]) ||
        one.z < kByChance || 1 - one.gain > kMuchWorse * (1 - best_gain) + noise)
      continue;
    list.push_back(one);
  }
  const double known = no_rival(task, rest, own) ? 1e300 : whole_error(own);
  std::vector<Attempt> others = attempts(task, rest, all, list, noise, known);
  const auto bristles = std::find_if(others.cbegin(), others.cend(), is_bristles);
  const Attempt* const other = bristles != others.cend() ? &*bristles : nullptr;
  for (const Attempt* a : {is_bristles(own) ? &own : nullptr, other}) {
    const Attempt dry = a ? without_bristles(task, rest, *a) : Attempt();
    if (!dry.state.fit.ok || dry.candidates.empty()) continue;
    others.push_back(dry);
    break;
  }
  return others;
}

bool by_whole_error(const Attempt& a, const Attempt& b) { return whole_error(a) < whole_error(b); }

bool stands_beside(const Attempt& own, const Attempt& t, double noise, double deviates) {
  return t.z > kByChance && unseen_agrees(t) && !clearly_better(own, t, noise, deviates);
}

// Which of `as_good` is named in place of `own`: the simplest, unless the data, few as they are, plainly speak for another.
void name_simplest(double noise, Attempt& own, std::vector<Attempt>& as_good) {
  for (Attempt& t : as_good)
    if ((t.complexity < own.complexity && !leaves_much_more(t, own, noise)) ||
        (t.complexity == own.complexity && whole_error(t) < whole_error(own)))
      std::swap(t, own);
}

// Of the others those that leave as little; `own` becomes the one that is to be named. Each of several may fall behind by chance, the
// right one too: up to kSure the nearest are said beside it.
std::vector<Attempt> as_good_as(const Task& task, const State& rest, double noise, std::vector<Attempt> others,
                                Attempt& own) {
  const bool own_can_be = !no_rival(task, rest, own);
  const auto is_none = [&](const Attempt& a) { return no_rival(task, rest, a); };
  if (own_can_be) others.erase(std::remove_if(others.begin(), others.end(), is_none), others.end());
  const auto better = std::min_element(others.begin(), others.end(), by_whole_error);
  if (better != others.end() && better->z > kByChance && whole_error(*better) < whole_error(own))
    std::swap(own, *better);
  const auto as_good_now = [&](const Attempt& t) { return stands_beside(own, t, noise, kByChance); };
  const auto behind = std::stable_partition(others.begin(), others.end(), as_good_now);
  std::vector<Attempt> as_good(std::make_move_iterator(others.begin()), std::make_move_iterator(behind));
  if (!own_can_be) put_drivers_behind(task, own, as_good);
  name_simplest(noise, own, as_good);
  std::sort(behind, others.end(), by_whole_error);
  for (auto t = behind; own_can_be && t != others.end() && as_good.size() < kMostBeside; ++t)
    if (stands_beside(own, *t, noise, kSure)) as_good.push_back(std::move(*t));
  std::sort(as_good.begin(), as_good.end(), by_whole_error);
  return as_good;
}

void weigh_one(const Task& task, const State& few, size_t i, Choice& choice) {
  Named& mine = choice.named[i];
  // judged together with the others that warm; or the rig as given follows nothing beside which to judge
  if (mine.candidate.terms[0].shape == kAcrossRecords || mine.of_numbers) return;
  State rest;
  if (!without(task, choice, few, i, rest)) return;
  double noise = noise_share(left_by(task.system, task.records, rest), rest.fit);
  if (noise > kMostlyNoise && few.seen.size() < choice.base.seen.size()) {  // then all are needed
    if (!without(task, choice, choice.base, i, rest)) return;
    noise = noise_share(left_by(task.system, task.records, rest), rest.fit);
  }
  Attempt own = own_beside(task, rest, choice, mine);
  const std::vector<Attempt> as_good =
      as_good_as(task, rest, noise, rivals_tried(task, rest, noise, choice, mine, own), own);
  if (!own.candidates[0].same_place(mine.candidate)) {
    mine.candidate = own.candidates[0], mine.z = own.z, choice.final = on_all(task, choice.final, own.state);
    keep_shape(choice.final.model, mine.candidate);
  }
  // what the rig as given leaves beside the band of its motion is not all noise: no more is than what is left beside the cause
  const double left_noise = own.error * noise_share(left_by(task.system, task.records, own.state), own.state.fit);
  mine.share = share_of(own, std::min(noise, left_noise));
  for (const Attempt& t : as_good)
    mine.rivals.push_back(
        Rival{t.candidates[0], t.error / own.error, moves_between(task, rest.model, own.state.model, t.state.model)});
}

}  // namespace

void weigh_rivals(const Task& task, const std::function<void(double)>& progress, Choice& choice) {
  if (choice.named.empty()) return;
  const State few = part_of(task, choice.base, 0);
  for (size_t i = 0; i < choice.named.size(); ++i) {
    weigh_one(task, few, i, choice);
    progress(static_cast<double>(i + 1) / static_cast<double>(choice.named.size()));
  }
}

}  // namespace diagnosis::runs
