// Which effects a rig lacks, as far as its records tell: causes one after the other, or two that help only together.
#pragma once
#include <functional>
#include <optional>

#include "../candidates/candidates.hpp"
#include "../residual/left.hpp"
#include "../residual/motion_error.hpp"

namespace diagnosis::runs {

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

// The rig as given, fitted over the longest windows that it can follow.
Choice rig_fitted(const Task& task);
// Whether the rig file as given is right already, of every channel that is measured; and whether what it misses of unseen data is too little for
// simulations to tell causes apart, where it is not noise.
bool right(const Task& task, const Choice& choice);
// Free run on unseen data, NRMSE of the worst DOF.
double missed_percent(const Task& task, const State& state);
bool near_enough(const Task& task, const Choice& choice);
// Takes causes that another test found and borne_out() confirms.
void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<std::vector<double>>& values,
           Choice& choice);
// Goes on from rig_fitted(): names what is missing. progress: called with the share done.
void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress);
// Whether every one of these, found by another test, is borne out: it stays significant beside the others, and without
// it unseen data are simulated worse.
bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<std::vector<double>>& values, State* fitted = nullptr);  // fitted: with all of them

}  // namespace diagnosis::runs
