// How well causes do beside a model, and whether chance could have done it.
#pragma once
#include "attempt.hpp"

namespace diagnosis::runs {

// Of a further number of a cause, or a further cause: a tenth of the squared error, which unseen windows hardly tell.
constexpr double kWorth = 1.1;

constexpr double kPlainlyLeft = 2;  // in the band of the motion over beside it: so much is worth a search among pitches

// Of what is still to be explained, that a cause has to take: seen, and where chance is no rival unseen too.
constexpr double kShare = 0.3;

constexpr double kShows = 0.02;  // of unseen windows' squared residual: less is lost in its scatter

// What so many causes together have to take of what is not noise; and whether the linearisation promises so little of it
// (a share of the squared residual) that even thrice as much would not do.
double least_share(size_t causes);
bool hopeless(double gain, size_t causes, double noise);
// Whether unseen windows speak for it, or have nothing to say (a sweep that has left the resonance).
bool unseen_agrees(const Attempt& a);
// Whether it leaves a twentieth less of the motion's error (a tenth of its square); or is sure, and pays on unseen windows beyond chance or takes one of
// the numbers beside which it was put out of its interval; or is beyond doubt where unseen windows cannot tell. Else nobody
// would act on it.
bool matters(const State& beside, const Attempt& a);
// Whether the 95 % interval of a coefficient from `added_from` on holds nought: such a cause is taken back in the end.
bool may_be_nought(const State& with, size_t added_from);
// Squared error on all windows, over that of the model beside.
double whole_error(const Attempt& a);
// Share of what is not noise that it takes, on the windows fitted.
double share_of(const Attempt& a, double noise);
// Share of the unseen windows' squared residual that the coefficients of the terms from `added_from` on move.
double expected_unseen(const State& state, size_t added_from);
// By how many deviations unseen windows gain more than noise would give: Attempt::unseen_deviations.
double deviations_unseen(const State& beside, const Attempt& a);
// Whether it may be named; already: causes named before it.
bool passes(const Attempt& a, size_t already, double noise);
// Whether it is sure, pays, and unseen windows agree; or beyond chance, and takes as much of seen and of unseen ones as a cause has to.
bool nearly(const Attempt& a);
// Whether the first leaves much more than the second and than noise, each number that it has less weighed.
bool leaves_much_more(const Attempt& a, const Attempt& than, double noise);
// Whether one is better than the other by more than these deviates of chance, and by much of what is not noise.
bool clearly_better(const Attempt& a, const Attempt& b, double noise, double deviates = kByChance);

}  // namespace diagnosis::runs
