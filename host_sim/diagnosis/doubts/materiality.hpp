// Whether what was named is worth naming.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {

constexpr double kLeastGain = 1.05;  // on unseen data: a twentieth less missed is not a number that anybody acts on

// Whether every DOF is simulated worse, by a twentieth, with the causes, and the rig as given simulates unseen data to 2 % or has a number
// wholly below nought beside them alone: they fit better and are not what acts here.
bool simulates_worse(const Diagnosis& d);

// Whether the free run of unseen data misses the whole motion with the causes (worst_free_run, percent) as without.
bool simulates_nothing(const Diagnosis& d, double worst_free_run);

// A cause beside which as much remains as before explains nothing: of what acts here it is not the name. Where only
// noise remains it is a cause still if the rig's own numbers are others beside it, and the forces they make are. Where the
// free run misses the whole motion with it as without, no window speaks for it.
// noise: whether nothing but noise is left; worst_free_run: of unseen data, in percent; base, full: the rig's terms without the causes and
// with them; d: its gains are the free runs', per DOF.
bool immaterial(const Task& task, const Choice& choice, bool noise, double worst_free_run,
                const std::vector<ActiveTerm>& base, const std::vector<ActiveTerm>& full, const Diagnosis& d);

}  // namespace diagnosis::runs
