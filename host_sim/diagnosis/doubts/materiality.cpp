#include "materiality.hpp"

#include <algorithm>
#include <cmath>

#include "../numbers/parameter_status.hpp"
#include "../trial/merit.hpp"
#include "laws_apart.hpp"

namespace diagnosis::runs {
namespace {

// Whether one of the rig's own coefficients leaves the interval that it had without the causes.
bool moved(const std::vector<ActiveTerm>& before, const std::vector<ActiveTerm>& after) {
  for (size_t i = 0; i < before.size() && i < after.size(); ++i)
    if (!before[i].known && std::abs(after[i].value - before[i].value) > kHalfOf95 * before[i].std) return true;
  return false;
}

// How many times smaller the error is, of the channel that gains most where all together do not lose: one sensor's fault
// shows in one of many. noise: mean square per channel that no model takes; empty: none.
double gain_of(const Fitted& now, const Fitted& before, const Vec& noise = Vec()) {
  const double together = error_over(now, before);
  if (!(together < 1)) return std::sqrt(1 / together);
  double least = 1;
  for (Index c = 0; c < now.mean_square.size(); ++c) {
    const double of_noise = noise.size() ? noise[c] : 0, beyond = before.mean_square[c] - of_noise;
    const double left = std::max(now.mean_square[c] - of_noise, 1e-12 * before.mean_square[c]);
    if (beyond > left) least = std::min(least, left / beyond);
  }
  return std::sqrt(1 / least);
}

// Whether unseen windows are too quiet to gain kLeastGain by what is named, though it acted on one channel alone; and gain it, as far as
// half of it can be told from noise.
bool gains_what_it_can(const Choice& choice) {
  const State &now = choice.final, &before = choice.base;
  const double acts = expected_unseen(now, before.model.size());
  const bool too_quiet =
      acts * static_cast<double>(now.unseen_fit.mean_square.size()) < 1 - 1 / (kLeastGain * kLeastGain);
  return too_quiet && error_over(now.unseen_fit, before.unseen_fit) < 1 - 0.5 * acts;
}

// By how much the windows gain. Unseen ones may be mostly noise (the end of a decay): where those of the fit gain, it is
// enough that of what is not noise in the others as much is gained.
double windows_gain(const Choice& choice) {
  const State &now = choice.final, &before = choice.base;
  const double seen = gain_of(now.fit, before.fit), unseen = gain_of(now.unseen_fit, before.unseen_fit),
               beyond_noise = gain_of(now.unseen_fit, before.unseen_fit, choice.final_left.noise);
  // what acts at large motion alone does not show in the end of a decay
  const bool hidden = gains_what_it_can(choice) || std::any_of(choice.named.begin(), choice.named.end(),
                                                               [](const Named& n) { return !n.shows_unseen; });
  return std::max(unseen, hidden ? seen : std::min(seen, beyond_noise));
}

}  // namespace

bool simulates_worse(const Diagnosis& d) {
  const bool nearly_right =
      std::all_of(d.baseline.holdout_nrmse_percent.begin(), d.baseline.holdout_nrmse_percent.end(),
                  [](double missed) { return missed < 100 * kSmall; });
  const auto any_impossible = [](const ModelScore& model) {
    return std::any_of(model.parameters.begin(), model.parameters.end(),
                       [](const diagnosis::Parameter& p) { return impossible(p); });
  };
  return (nearly_right || (any_impossible(d.extended) && !any_impossible(d.baseline))) &&
         std::all_of(d.gain.begin(), d.gain.end(), [](double gain) { return gain * kLeastGain < 1; });
}

bool simulates_nothing(const Diagnosis& d, double worst_free_run) {
  const std::vector<double>& without = d.baseline.holdout_nrmse_percent;
  return worst_free_run > 100 &&
         std::any_of(without.begin(), without.end(), [](double missed) { return missed > 100; });
}

bool immaterial(const Task& task, const Choice& choice, bool noise, double worst_free_run,
                const std::vector<ActiveTerm>& base, const std::vector<ActiveTerm>& full, const Diagnosis& d) {
  if (choice.named.empty()) return false;
  if (simulates_worse(d) || simulates_nothing(d, worst_free_run)) return true;
  const bool pays =
      std::all_of(choice.named.begin(), choice.named.end(), [](const Named& n) { return n.unseen_deviations > kSure; });
  if (noise && (pays || moved(base, full)) && laws_apart(task, choice.base.model, choice.final.model) > kLeastGain - 1)
    return false;
  return (windows_gain(choice) < kLeastGain || worst_free_run > 100) &&
         std::all_of(d.gain.begin(), d.gain.end(), [](double gain) { return gain < kLeastGain; });
}

}  // namespace diagnosis::runs
