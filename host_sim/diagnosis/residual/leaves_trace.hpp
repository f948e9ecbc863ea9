// Whether a trace that the rows see shows in free runs.
#pragma once
#include "left.hpp"

namespace diagnosis::runs {

// Rows and runs err in different ways: rows round friction at its reversals, which repeats with a drive of sines; runs do not. A tone
// that is there shows in both. In some channel of a record, beyond what one in a hundred records of noise have there.
bool leaves_tone(const Task& task, const State& state, double hertz);

// A force that repeats with a link's elongation: of all pitches and phases beside the model the likeliest is beyond chance. What the way
// holds less than one and a half times does not repeat.
bool leaves_repetition(const Task& task, const State& state, int link);

}  // namespace diagnosis::runs
