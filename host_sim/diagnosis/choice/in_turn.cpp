#include "in_turn.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "../doubts/needless.hpp"
#include "../doubts/possible.hpp"
#include "../doubts/shown.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "../valleys/other_shapes.hpp"
#include "free_damping.hpp"
#include "round.hpp"
#include "warming.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kMostCauses = 4;
constexpr double kTogether = 0.5;  // of what one cause leaves, that dampers which drift together may

// What stood beside the cause named last, and what left about as little as that one.
struct PassedOver {
  State beside, part;  // and the part of its windows over which they were tried
  std::vector<Candidate> candidates;
  int complexity = 0;  // of the cause that was named
};

// A cause was passed over for one that did as well, and that now wants a further one: alone it may do as well as the two (a gap
// beside a wrong spring whose misfit an end stop mends). Nothing where none does.
struct Alone {
  State state;
  Candidate candidate;
  std::vector<Candidate> outdone;  // of those passed over
};
std::optional<Alone> alone_as_good(const Task& task, const PassedOver& passed, const State& both, int further,
                                   double worth) {
  if (passed.candidates.empty()) return {};
  std::optional<Alone> best;
  std::vector<Candidate> outdone;
  for (const Candidate& candidate : passed.candidates) {
    const Attempt alone =
        attempt(task, passed.part, {candidate}, {std::vector<double>(candidate.terms.size(), 0.0)}, kBaseSteps);
    if (!alone.state.fit.ok || alone.rounds || !can_stand(task, passed.part, alone)) continue;
    const State whole = on_all(task, passed.beside, alone.state);
    // a number for each cause, and its shapes
    const double may_leave = std::pow(worth, passed.complexity + further + 1 - alone.complexity);
    if (!whole.fit.ok || error_over(whole.fit, both.fit) > may_leave ||
        error_over(whole.unseen_fit, both.unseen_fit) > may_leave) {
      outdone.push_back(candidate);
      continue;
    }
    if (!best || error_over(whole.fit, best->state.fit) < 1) best = Alone{whole, candidate, {}};
  }
  if (best) keep_shape(best->state.model, best->candidate), best->outdone = outdone;
  return best;
}

void name(const Attempt& best, double noise, Choice& choice) {
  for (Candidate c : best.candidates) {
    keep_shape(best.state.model, c);
    choice.named.push_back(
        Named{c, best.z, share_of(best, noise), {}, best.shows_unseen, false, best.unseen_deviations});
  }
}

// The one named last, exchanged for another that it had outdone.
void exchange(const Alone& alone, Choice& choice) {
  Named& last = choice.named.back();
  last.outdone = alone.outdone, last.outdone.push_back(last.candidate), last.candidate = alone.candidate;
}

}  // namespace

void name_in_turn(const Task& task, double worth, Choice& choice, const std::function<void(double)>& progress) {
  State now = choice.final;
  PassedOver passed;
  bool warmed = false;
  size_t freed = 0, exchanged = 0;
  const size_t most = choice.named.size() + kMostCauses;
  const double motion = motion_over_error(task, choice.base);
  while (choice.named.size() < most) {
    const double left = error_over(now.fit, choice.base.fit);
    if (!choice.named.empty() && takes_little(left, 0, motion)) break;  // no cause could take that much
    const Left remains = left_by(task.system, task.records, now);
    const double noise = noise_share(remains, now.fit);
    now.noise = remains.noise;
    const State part = part_of(task, now, noise);
    Round round = round_of(task, part, choice.named.size(), remains, noise, worth, choice);
    if (round.stuck) {
      now = on_all(task, now, round.unstuck);
      if (choice.named.empty())
        choice.base = choice.final = now, choice.base_left = left_by(task.system, task.records, now);
      if (++freed > kMostCauses) break;
      continue;
    }
    if (!warmed) {
      const Attempt warm = warming(task, part, noise);
      if (warm.state.fit.ok && (!round.found || whole_error(warm) < kTogether * whole_error(round.best)))
        round.best = warm, round.found = warmed = true;
    }
    if (!round.found) break;
    if (!choice.named.empty() && takes_little(left, left * round.best.error, motion)) break;
    State with = on_all(task, now, round.best.state);
    if (const auto other = from_other_shapes(task, now, round.best.candidates, with)) {
      with = other->state;
      settle(task, with, kBaseSteps);
    }
    free_damping(task, with);
    if (all_shown(task, round.best.state.model) && !all_shown(task, with.model)) break;
    const auto alone =
        exchanged < kMostCauses ? alone_as_good(task, passed, with, round.best.complexity, worth) : std::nullopt;
    if (alone) {
      ++exchanged;
      exchange(*alone, choice);
      now = alone->state, passed = {};
      continue;
    }
    passed = {now, part, round.passed_over, round.best.complexity};
    name(round.best, noise, choice);
    now = with;
    progress(static_cast<double>(choice.named.size()) / static_cast<double>(most));
  }
  drop_needless(task, choice.base, now, choice.named);
  drop_idle_damping(task, now, choice.named);
  choice.final = now;
}

}  // namespace diagnosis::runs
