#include "hidden_mode.hpp"

#include "../choice/free_damping.hpp"
#include "../choice/horizon.hpp"
#include "../first_values/mode_scan.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kOutdone = 0.5;    // of the squared error that other causes leave
constexpr double kWorthAFit = 0.7;  // of the balance that the rig alone leaves: what leaves more is not tried

Candidate candidate_of(const HiddenMode& mode) {
  Candidate c;
  c.terms = {on_dof(Kind::kResonance, mode.dof, mode.resonance_Hz, mode.damping_ratio)};
  c.complexity = 2;
  return c;
}

// Other causes, named before, over these windows: they have to leave much more.
bool outdoes(const Task& task, const State& found, const Choice& before, double periods) {
  if (before.named.empty()) return true;
  State other = before.final;
  lay(task, periods, other);
  settle(task, other, kBaseSteps);
  return !other.fit.ok ||
         (error_over(found.fit, other.fit) < kOutdone && error_over(found.unseen_fit, other.unseen_fit) < kOutdone);
}

// choice: over windows of the rig as given, nothing named; before: what was said before.
bool adopted(const Task& task, const SpectralBalance& balance, const HiddenMode& mode, const Choice& before,
             Choice& choice) {
  State beside = choice.base;
  beside.model = with_numbers(balance, mode.numbers, choice.base.model);
  const Attempt found = attempt(task, beside, {candidate_of(mode)}, {{mode.mass_kg}}, kBaseSteps, From::kMeasured);
  if (!found.state.fit.ok || found.unresolved || !follows(task, found.state) ||
      !outdoes(task, found.state, before, choice.periods))
    return false;
  // what it brings is told beside the rig as given, whose numbers are not those that the attempt started from
  choice.base_left = left_by(task.system, task.records, choice.base);
  const double noise = noise_share(choice.base_left, choice.base.fit);
  if (!passes(found, 0, noise)) return false;
  Candidate named = found.candidates[0];
  keep_shape(found.state.model, named);
  choice.named.push_back(
      Named{named, found.z, share_of(found, noise), {}, found.shows_unseen, false, found.unseen_deviations});
  choice.base_fits_nothing = false;
  choice.final = found.state;
  free_damping(task, choice.final);
  return true;
}

}  // namespace

bool name_hidden_mode(const Task& task, Choice& choice) {
  if (massless(choice.base.model) || task.records[0].base.given()) return false;  // sought beside forces alone
  const SpectralBalance balance = spectral_balance(task.system, task.records, choice.base.model);
  const std::optional<HiddenMode> mode = hidden_mode(balance, choice.base.model);
  if (!mode || mode->left > kWorthAFit) return false;
  for (double periods = longest_horizon(task.records); periods >= kLeastPeriods; periods /= kShorter) {
    Choice over = over_windows(task, choice, periods);
    over.named.clear();
    if (!over.base.fit.ok || over.base.unseen.empty() || !adopted(task, balance, *mode, choice, over)) continue;
    choice = over;
    return true;
  }
  return false;
}

}  // namespace diagnosis::runs
