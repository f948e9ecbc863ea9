#include "other_shapes.hpp"

#include <algorithm>

#include "../trial/settle.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kAtRest = 0.5;  // promised fall: within a standard deviation of the lowest point that the slopes see
constexpr double kTimes[] = {0.25, 0.5, 2, 4};  // of a shape that was reached

bool is_stuck(const Fitted& fit) { return promised_fall(fit) > kAtRest * fit.memory; }

bool has_free_shape(const Model& model, const Candidate& c) {
  return std::any_of(model.begin(), model.end(),
                     [&](const ModelTerm& t) { return t.added && t.shape_free && t.term.same_place(c.terms[0]); });
}

}  // namespace

std::optional<Attempt> from_other_shapes(const Task& task, const State& beside,
                                         const std::vector<Candidate>& candidates, const State& reached) {
  std::optional<Attempt> best;
  if (!reached.fit.ok || !is_stuck(reached.fit)) return best;
  std::vector<Candidate> found = candidates;
  std::vector<std::vector<double>> start;
  for (Candidate& c : found) keep_shape(reached.model, c), start.emplace_back(c.terms.size(), 0.0);
  for (size_t i = 0; i < found.size(); ++i) {
    if (!has_free_shape(reached.model, found[i])) continue;
    for (const double times : kTimes) {
      std::vector<Candidate> others = found;
      others[i].terms[0].shape *= times;
      const Attempt a = attempt(task, beside, others, start, kTrialSteps, From::kMeasured);
      const double lowest = best ? best->state.fit.cost : reached.fit.cost;
      if (a.state.fit.ok && !a.rounds && a.state.fit.cost < lowest) best = a;
    }
  }
  return best;
}

}  // namespace diagnosis::runs
