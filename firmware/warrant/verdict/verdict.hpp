// What the score tests make of the estimates: which are withdrawn, and who is named for it.
//
// MODEL_SUSPECT: a force that the model lacks is beyond chance and over 3 % of the damping force beside it: no estimate of
// the rig is believed, because a wrong term bends its neighbours too. But for those that it does not bend: what is named explains what
// stands out, is neither a channel's fault nor the half of a mode that a spring or a mass makes, and neither it nor what else stands out
// half as much bends the coefficient by more than its deviation. Also the whole rig where a coefficient that physics
// keeps positive is below zero by four deviations (one that the data determine).
// BIAS_SUSPECT: the score tests' instrument, which reaches four samples to either side, says another value: by more than
// four deviations of the difference (Student's, few stretches may tell it), the half width of the interval and 1/40 of the value.
// UNTESTED: a coefficient that physics keeps positive has an interval wholly below zero (of right ones that are nought one in 40 has),
// and whatever stands in an equation of motion with it; what stands beside a mass that the data do not tell from nought.
// Or what the record does not exclude would make the coefficient wrong, by over 4 of its deviations and over 1/20 of its value: a force
// that is found near the limit of chance, and one deviation more; a damping law of its own link of three deviations, or of which
// too few stretches tell how well it is known; where one quantity of a DOF is measured, a force that two deviations
// are found of. And what the score tests' own fit says of it. And where one law of a link is in doubt another one is
// too that a force of two deviations puts beyond its interval and makes wrong.
// One level, and the rate of a coefficient's link has one amplitude, as with one tone (mean of w^4 over the squared mean of w^2
// below 1.56; 1.5 for one tone, 2.25 for two, 3 for a random band): other damping laws differ in their harmonics alone, and have
// to be excluded with two deviations whatever is found of them. With displacements alone also where a damping law of the link
// cannot be told from its coefficients. Where one quantity of a DOF is measured also where the tests' own fit hardly determines the
// coefficient. And where the record is too short to test anything.
// Where signals pass filters and nobody has said how much noise their channels have, the score tests are not calibrated:
// they say nothing, warrant.tested is false, and only impossible coefficients and late channels are told.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {

struct TestState {
  bool
      judged;  // the score tests have judged these very estimates; else there was too little, or they are not calibrated
  int levels;  // measured so far
};

void give_verdict(const CoreConfiguration& configuration, const ScoreSums& sums, const ScoreTest& test, TestState state,
                  Estimates& estimates);

}  // namespace firmware
