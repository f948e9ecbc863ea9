#include "rounded_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "../trial/paired.hpp"
#include "../trial/settle.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kFirst = 1;    // samples: a filter that ends at a fifth of the rate rounds as wide
constexpr double kWidest = 4;   // wider ones would take motion away
constexpr double kStep = 1.41;  // times, from one width to the next

bool jumps(const Model& model) {
  return std::any_of(model.begin(), model.end(), [&](const ModelTerm& t) {
    const bool bends = std::any_of(model.begin(), model.end(), [&](const ModelTerm& m) {
      return m.host >= 0 && &model[static_cast<size_t>(m.host)] == &t;
    });
    return !bends && t.value != 0 &&
           (t.term.kind == Kind::kCoulomb || t.term.kind == Kind::kMissingCoulomb || t.term.kind == Kind::kStribeck);
  });
}

bool accelerations(const std::vector<Prepared>& records) {
  const std::vector<MotionTrace>& traces = records[0].traces;
  return std::any_of(traces.begin(), traces.end(), [](const MotionTrace& t) { return t.quantity == 2; });
}

void round_over(double samples, std::vector<Prepared>& records) {
  for (Prepared& p : records) p.rounded_over = samples;
}

State settled(const Task& task, std::vector<Prepared>& records, double samples, State from) {
  round_over(samples, records);
  settle(task, from, kTrialSteps);
  return from;
}

bool leaves_less(const State& a, const State& b) { return a.fit.ok && (!b.fit.ok || a.fit.cost < b.fit.cost); }

}  // namespace

bool round_jumps(const Task& task, std::vector<Prepared>& records, State& fitted) {
  if (!fitted.fit.ok || massless(fitted.model) || !jumps(fitted.model) || !accelerations(records)) return false;
  double width = kFirst;
  State best = settled(task, records, width, fitted);
  if (!leaves_less(best, fitted)) {  // jumps are less than half as wide: no filter that matters
    round_over(0, records);
    return false;
  }
  for (const double factor : {kStep, 1 / kStep}) {
    bool better = false;
    while (width * factor < kWidest && width * factor > 1 / kWidest) {
      State next = settled(task, records, width * factor, best);
      if (!leaves_less(next, best)) break;
      best = std::move(next), width *= factor, better = true;
    }
    if (better) break;
  }
  const bool helps = leaves_less(best, fitted) && paired_z(fitted.fit, best.fit) > kSure;
  round_over(helps ? width : 0, records);
  if (helps) fitted = std::move(best);
  return helps;
}

}  // namespace diagnosis::runs
