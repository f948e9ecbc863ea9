// Which effects a rig lacks, as far as its records tell: causes one after the other, or two that help only together.
#pragma once
#include <functional>
#include <optional>

#include "../candidates/candidates.hpp"
#include "../windows/windows.hpp"

namespace diagnosis::runs {

// Everything a fit needs, and what it left.
struct State {
  Model model;
  std::vector<Window> seen, unseen;
  Fitted fit, unseen_fit;
  Vec noise = {};  // of each channel, mean square, as left_by() has it; empty: not asked
};

struct Move {
  std::string name;  // of a parameter: "viscous[1-0]", "cogging_pitch[1-0]"
  double by = 0;     // SI units
};

struct Rival {
  Candidate candidate;
  double error = 0;  // squared error over that of the model named
  std::vector<Move> moves =
      {};  // by how much the rig's unknown numbers, and those of the other causes, are other beside it
};

struct Named {
  Candidate candidate;
  double z = 0;      // significance
  double share = 0;  // of what was still to be explained
  std::vector<Rival> rivals;
  bool shows_unseen = true;      // whether unseen windows could show it
  bool of_numbers = false;       // the rig file has it wrong by much: beside it as given rivals say nothing
  double unseen_deviations = 0;  // by which unseen windows gain more than by chance
  bool of_channels = false;      // a sensor's fault that channels of its DOF show among themselves, whatever the rig is
  std::vector<Candidate> outdone = {};  // that wanted a further cause where this one does alone: no rivals
};

// A cause that was not named: it takes too little of what is left, or unseen data do not say enough. Yet it is beyond chance, they
// agree, and it pays.
struct Nearly {
  Candidate candidate;
  Model model;       // the rig's numbers beside it
  double share = 0;  // of what is not noise, that it takes
};

// Whether what is left goes with the motion of its own window, or as well with that of any other: with_motion().
struct WithMotion {
  bool known = false;  // false: too few windows, too short ones, or nothing beyond the level beside the motion's band
  double share = 0;    // of the squared residual, corrected for chance
  double std = 0;      // of `share`, from its scatter between windows
  double z = 0;        // of its mean over windows, as a normal deviate
};

// Noise does not know how loud the motion is: how the error of windows goes with their motion.
struct WithLoudness {
  double z = 0;            // of the correlation of both logarithms, as a normal deviate
  double quiet_share = 1;  // of the squared residual, that would be left if all windows were as the quieter quarter
};

// A channel's line at the mains' frequency.
struct Hum {
  double hertz = 0, amplitude = 0;  // 0: none; of the channel, SI units
  double over = 0;                  // the level around
  bool driven = false;              // something drives the rig there: a model's error may look so
};

// What is left, channel by channel.
struct Left {
  Vec noise;         // mean square of what looks like noise: the level above the motion's band
  Vec sensor_noise;  // of that what the drives' noise does not make of it
  Vec in_band;       // residual's level in the band of the motion over that beside it
  // Highest single line of a residual's spectrum in that band over the level around it, mains left out; and that of
  // those at which nothing drives the rig.
  double line = 0, foreign_line = 0;
  std::vector<Hum> hum;
  WithMotion with_motion;
  WithLoudness with_loudness;
  double worst() const { return in_band.size() ? in_band.maxCoeff() : 0; }
};
// Whether more than noise is left: more in the band of the motion than beside it, and not of a colour that noise may
// have.
bool beyond_noise(const Left& left);
// Whether numbers beside named causes are not vouched for: more than noise is left, or more than white noise makes by far and two
// deviations say that it goes with the motion.
bool may_bend_numbers(const Left& left);

struct Choice {
  double periods = 0;  // of a window
  State base, final;
  std::vector<Named> named;
  std::vector<Nearly> nearly;  // beside what is named, over these windows; the best first
  std::optional<Nearly>
      nearest;  // where nothing is named: what takes most of seen and of unseen windows, though no test bears it out
  Left base_left, final_left;
  Screen last_screen;  // beside the final model
  std::vector<Candidate> last_candidates;
  std::vector<Hum> hum_taken;      // out of the records' channels before this fit; empty: none
  bool searched = false;           // by choose()
  bool noise_is_enough = false;    // no other test says that something beyond noise is left
  bool base_fits_nothing = false;  // not even over a fifth of a period does the rig as given describe the motion
};

// The rig as given, fitted over the longest windows that it can follow; `training` of the records may be fitted, the
// others are unseen (where there are none, the last 30 % of each).
struct Task {
  const System& system;
  const std::vector<Prepared>& records;
  size_t training;
};
Choice rig_fitted(const Task& task);
// Whether the rig file as given is right already, of every channel that is measured; and whether what it misses of unseen data is too little for
// simulations to tell causes apart, where it is not noise.
bool right(const Task& task, const Choice& choice);
// Free run on unseen data, NRMSE of the worst DOF.
double missed_percent(const Task& task, const State& state);
bool near_enough(const Task& task, const Choice& choice);
constexpr double kFollows =
    0.25;  // of the motion, error: up to it a linearisation is trusted and fitted states help others
constexpr double kInPhase = 0.5;  // of the motion, error: up to it a run is still in phase
// Times the variance of its noise: less motion than that a sensor does not show, and what is simulated for it cannot be judged.
constexpr double kShown = 4;
// Of the motion, of each link's too, over windows and in free runs of unseen data: calibrations of sensors are not much
// better, and where nothing in the vocabulary brings it down nobody would act on it. No other valley of the error is as low.
constexpr double kSmall = 0.02;
constexpr double kAsGoodAsRight = 1e-3;  // of the motion, over a window: no sensor of a rig is better
// Error of the windows' runs over the motion, the worst channel's; huge where there is no fit.
// links_too: of the motions between two DOFs as well.
double motion_error(const Task& task, const State& state, bool links_too = true);
// Whether windows can tell valleys apart: kFollows, but for what a channel misses all the time, which moves no phase and no shorter
// window would mend (a sensor's zero, a constant force). Where nothing drives the rig it is enough that half of the stretches are followed so: the
// loud start outweighs all others, and another mode of a blow, which dies out there, moves no phase either.
bool follows(const Task& task, const State& state, bool links_too = true);
// Takes causes that another test found and borne_out() confirms.
void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<std::vector<double>>& values,
           Choice& choice);
// Goes on from rig_fitted(): names what is missing. progress: called with the share done.
void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress);
// Whether every one of these, found by another test, is borne out: it stays significant beside the others, and without
// it unseen data are simulated worse.
bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<std::vector<double>>& values, State* fitted = nullptr);  // fitted: with all of them

// Share of a fit's squared residual that looks like noise, mean over the channels.
double noise_share(const Left& left, const Fitted& fit);
Left left_by(const System& system, const std::vector<Prepared>& records, const State& state);
// Squared error of a state over that of another, mean over the channels; seen or unseen windows.
double error_over(const Fitted& now, const Fitted& before);

}  // namespace diagnosis::runs
