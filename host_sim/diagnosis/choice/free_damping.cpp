#include "free_damping.hpp"

#include "../residual/motion_error.hpp"
#include "../trial/settle.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNoWorse =
    1.02;  // of the squared error of unseen windows: what is as good has an honest interval besides

}  // namespace

bool free_damping(const Task& task, State& with) {
  State freed = with;
  bool any = false;
  for (ModelTerm& t : freed.model) {
    if (t.term.kind != Kind::kResonance || !t.added || t.shape2_free || !(t.term.shape2 > 0)) continue;
    t.shape2_free = any = true;
  }
  if (!any) return false;
  settle(task, freed, kBaseSteps);
  if (!freed.fit.ok || error_over(freed.fit, with.fit) >= 1 ||
      error_over(freed.unseen_fit, with.unseen_fit) >= kNoWorse)
    return false;
  with = freed;
  return true;
}

}  // namespace diagnosis::runs
