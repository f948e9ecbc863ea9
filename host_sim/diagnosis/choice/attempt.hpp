// Candidates put beside a model and fitted with it: how well that does, and whether chance could have done it.
#pragma once
#include "choice.hpp"

namespace diagnosis::runs {

struct Attempt {
  std::vector<Candidate> candidates;
  State state;
  double error = 1e300, unseen = 1e300;  // squared, over that of the model beside which they were put
  double quieter = 1;  // noise's share of that model's squared error on unseen windows over that on seen ones
  double z = 0;        // of the least significant candidate
  int complexity = 0;  // numbers beside the coefficients
  // Whether unseen windows can tell: what it would bring there, as a share of their squared residual, is more than
  // chance.
  bool shows_unseen = true;
  double expected_unseen = 0;  // share of their squared residual that its own numbers move
  // Of one cause alone: by how many standard deviations unseen windows gain more than noise would give, at least. It was fixed
  // before they were asked: chance has one try.
  double unseen_deviations = 0;
  // Its friction bends within a sample, as a filter rounds a jump: no cause, but what causes have to stand beside.
  bool rounds = false;
};

constexpr double kMostlyNoise =
    0.5;  // of the squared residual: above it chance is the rival, below it other causes are

// Of a further number of a cause, or a further cause: a tenth of the squared error, which unseen windows hardly tell.
constexpr double kWorth = 1.1;

constexpr size_t kShortList = 5;  // causes that a search tries first, those that the linearisation promises most of

constexpr double kPlainlyLeft = 2;  // in the band of the motion over beside it: so much is worth a search among pitches

// Of what is still to be explained, that a cause has to take: seen, and where chance is no rival unseen too.
constexpr double kShare = 0.3;

// The model with its free numbers and states fitted over the seen windows; over the unseen ones its states alone.
void settle(const Task& task, State& s, int steps);

// Every so many windows of a state, fitted: where most of what is left is not noise a part of a long record tells
// causes apart as well as all of it. And what was found on one state, fitted to the windows of another; where they are the
// same it goes on from the states found.
State part_of(const Task& task, const State& whole, double noise);
State on_all(const Task& task, const State& whole, const State& found);

constexpr int kBaseSteps = 12, kTrialSteps = 6;  // of Gauss-Newton: to rest, and near enough to compare
// Where windows' states start: as fitted for the model beside, or (where that was far off) as measured.
enum class From { kBeside, kMeasured };
Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& candidates,
                const std::vector<std::vector<double>>& values, int steps, From from = From::kBeside);
// One that was screened; `all`: where a gentler shape of it is found when the best one does not converge; noise: its share of
// the squared residual.
Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                double noise);

// Whether one fitted cause is friction whose bristles bend; and the same with friction that does not, fitted from there: over
// long windows the error of dry friction has valleys of its own, which bristles lead around. Where they act in the place
// of the rig's own friction that is the model beside which they were put, and no cause.
bool is_bristles(const Attempt& a);
Attempt without_bristles(const Task& task, const State& beside, const Attempt& bristles);

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
// Share of the unseen windows' squared residual that the coefficients of the terms from `added_from` on move.
double expected_unseen(const State& state, size_t added_from);
// A candidate as it was fitted: with its shape, one term.
void keep_shape(const Model& fitted, Candidate& candidate);
// Squared error on all windows, over that of the model beside.
double whole_error(const Attempt& a);
// Share of what is not noise that it takes, on the windows fitted.
double share_of(const Attempt& a, double noise);
// Beside the rounding of frictions that is significant among those tried, all of it together; no fit where there is none.
State rounded(const Task& task, const State& beside, const std::vector<Attempt>& tried);
// Whether it may be named; already: causes named before it.
bool passes(const Attempt& a, size_t already, double noise);
// Whether it is sure, pays, and unseen windows agree; or beyond chance, and takes as much of seen and of unseen ones as a cause has to.
bool nearly(const Attempt& a);
// How much less the second leaves than the first, paired over blocks, as a normal deviate.
double paired_z(const Fitted& first, const Fitted& second);
// The same of each block's own share, so that a loud one counts as a quiet one.
double paired_share_z(const Fitted& first, const Fitted& second);
// Whether the first leaves much more than the second and than noise, each number that it has less weighed.
bool leaves_much_more(const Attempt& a, const Attempt& than, double noise);
// Whether one is better than the other by more than chance, and by much of what is not noise.
bool clearly_better(const Attempt& a, const Attempt& b, double noise);

}  // namespace diagnosis::runs
