#include "judge.hpp"

#include <algorithm>
#include <cmath>

#include "../doubts/possible.hpp"
#include "../doubts/shown.hpp"
#include "../doubts/unresolved_mode.hpp"
#include "../residual/motion_error.hpp"
#include "merit.hpp"
#include "paired.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMostGain = 0.2;  // error of a calibration

double least_z(const Attempt& a, size_t added_from) {
  const std::vector<Determined> d = determined(a.state.fit, a.state.model);
  const std::vector<Parameter> p = parameters_of(a.state.model);
  double least = 1e300;
  for (size_t i = 0; i < p.size(); ++i)
    if (p[i].term >= added_from && !p[i].shape) least = std::min(least, std::abs(d[i].z));
  return least;
}

// Noise's share of what a model leaves of unseen windows over that of seen ones: channel by channel, as one may be noise alone while
// another shows what is missing. Where the noise is not known: as of one channel.
double quieter_of(const State& beside) {
  if (!beside.unseen_fit.ok) return 1;
  if (beside.noise.size() == 0) return error_over(beside.fit, beside.unseen_fit);
  const auto share = [&](const Fitted& f) { return beside.noise.cwiseQuotient(f.mean_square).cwiseMin(1.0).mean(); };
  return share(beside.unseen_fit) / std::max(1e-12, share(beside.fit));
}

// The only channel of a rig that nothing drives tells its own gain by the bend of a law alone. More than a calibration may be
// off is that law, not the gain.
bool is_no_calibration(const Task& task, const ModelTerm& t) {
  const Prepared& p = task.records[0];
  return t.term.kind == Kind::kChannelGain && std::abs(t.value) > kMostGain && p.traces.size() == 1 &&
         !forced(task.records) && !p.guess.back().given;
}

}  // namespace

void judge(const Task& task, const State& beside, bool hosted, Attempt& a) {
  a.error = error_over(a.state.fit, beside.fit), a.unseen = error_over(a.state.unseen_fit, beside.unseen_fit);
  a.quieter = quieter_of(beside);
  for (size_t i = beside.model.size(); i < a.state.model.size(); ++i) {
    if (is_no_calibration(task, a.state.model[i])) a.state.fit.ok = false;
    if (shown(task, a.state.model[i])) continue;
    if (a.state.model[i].term.kind == Kind::kPresliding)
      a.rounds = true;
    else
      a.state.fit.ok = false;
  }
  a.no_sensors = is_no_sensors(a.state, a.candidates), a.unresolved = is_unresolved_mode(task, a.state, a.candidates);
  if (!a.state.fit.ok || a.rounds) return;
  a.z = std::min(1e300, least_z(a, beside.model.size()));
  a.unseen_deviations = a.candidates.size() <= 2 ? deviations_unseen(beside, a) : 0;
  a.expected_unseen = expected_unseen(a.state, beside.model.size());
  a.shows_unseen = !a.state.unseen_fit.ok || 1 - a.unseen > kShows || a.expected_unseen > kShows;
  // what acts in another's place has no coefficient of its own: what it brings, block by block
  // (of a sweep two or three are by far the loudest: as a share of their own)
  if (hosted) a.z = std::min(a.z, std::max(paired_z(beside.fit, a.state.fit), paired_share_z(beside.fit, a.state.fit)));
}

}  // namespace diagnosis::runs
