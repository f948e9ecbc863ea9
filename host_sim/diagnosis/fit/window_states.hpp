// The free states of windows: how they follow a step of the numbers, and what else is tried for them.
#pragma once
#include "windows_pass.hpp"

namespace diagnosis::runs {

// How a window's state moves beside a change of the parameters. Damped: what the window hardly determines stays near where it was.
Vec state_change(const Normal& window, const Vec& change, double damping);

// Windows that a step led astray, as one does that starts at rest and hardly determines its state: they would hold all others
// back. Beside given parameters each window is on its own: those that are worse than before go a damped way instead, or stay,
// whichever leaves the least. True where any had left the motion altogether.
bool shorter_ways(Evaluator& evaluator, const WindowsPass& now, const WindowsPass& next, const Vec& change,
                  const Vec& weights, const std::vector<Window>& windows, std::vector<Window>& moved);

// A state fitted beside another model may lie where this one does not come back from (a damping that falls with the rate): such a
// window starts from the measured motion, or from rest. True where any does.
bool started_afresh(Evaluator& evaluator, std::vector<Window>& windows);

bool has_friction(const Model& model);
// Dry friction makes valleys of a window's error: where a link sticks the first guess of its state leads elsewhere.
// The run from where the window before ended, or from rest where none is before it, may lie in the right one. True
// where any window took such a state.
bool carried_on(Evaluator& evaluator, const Vec& weights, std::vector<Window>& windows);

}  // namespace diagnosis::runs
