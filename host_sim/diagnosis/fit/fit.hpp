// Output error over windows with free states: Gauss-Newton on the sum over channels of the logarithm of the mean
// square.
#pragma once
#include "error_rates.hpp"
#include "evaluator.hpp"

namespace diagnosis::runs {

struct Fitted {
  bool ok = false;
  double cost = 0;    // sum over channels of N/2 log(mean square)
  Vec mean_square;    // per channel, over the windows of the fit
  size_t parts = 1;   // blocks per window: consecutive stretches of it
  double memory = 1;  // samples over which what is left resembles itself: sum of squared correlations, worst channel
  double block_length = 1;    // samples, mean
  std::vector<Vec> block_ss;  // per block: square sum per channel
  std::vector<Mat> gram;      // per block: parameters' normal matrix beside the windows' free states, weighted
  std::vector<Vec> score;     // per block: its right-hand side
};

constexpr size_t kBlocks = 24;         // that differences are paired over: fewer leave Student's law no way to be sure
constexpr size_t kEnoughWindows = 12;  // with free states of their own they are blocks that share nothing
size_t parts_for(size_t windows);      // such blocks per window
constexpr size_t kFiner = 8;           // blocks of a fit in each of those

// How each parameter is determined: influences of blocks, corrected for leverage. For the interval blocks are a 24th of all, or
// whole windows, and the wider counts (neighbouring blocks share what a model lacks). For the deviate they are ten times as
// long as what is left resembles itself, so that an effect that acts in one burst is not judged as one event.
struct Determined {
  double std = 0;  // of the parameter, so that value +- 1.96 std is its 95 % interval
  // The records show it and others together only: of its column no more than 10^-4 is orthogonal to theirs, as much as a simulation is
  // right to. Where dry friction acts in one direction alone, a constant force is the same.
  bool alike = false;
  double z = 0;  // of a coefficient: value over standard error with all shapes held, as a normal deviate
};
std::vector<Determined> determined(const Fitted& fit, const Model& model);

// Fits the model's free numbers and the states of the windows; `only_states` leaves the numbers alone.
Fitted fit(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
           int iterations, bool only_states = false);
// The same on the way to another fit: nothing is said of what was found, but how many passes over the windows with slopes it took.
// They are what a fit costs.
size_t approach(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
                int iterations, bool only_states = false);

// Fall of the cost that the slopes promise where a fit ended: half the square of the way to their lowest point in standard deviations.
double promised_fall(const Fitted& fit);

// A normal deviate as unlikely as t of Student's law.
double normal_deviate(double t, double dof);

}  // namespace diagnosis::runs
