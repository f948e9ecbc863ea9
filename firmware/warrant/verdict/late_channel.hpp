// Channels that the kinematic identities find late (firmware/identification/conditions/skew.hpp), and what the equations of motion say of them.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {

// The worst of them: no rig model is needed to name it. False: there is none.
bool late_channel(const CoreConfiguration& configuration, const Estimates& estimates, Finding& worst);

// With the score tests' answers: a force that is held from sample to sample, not an acceleration that is early; whether an
// acceleration beside a force is late at all (Warrant::confirmed); of a displacement and an acceleration without a velocity, which
// of the two is late, or has another gain.
void ask_equations(const CoreConfiguration& configuration, const ProbePlan& plan, const ScoreTest& test,
                   Estimates& estimates, Finding& late);

}  // namespace firmware
