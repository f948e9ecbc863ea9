// One run of all windows: what each says of its state and of the parameters, and what is left in all.
#pragma once
#include "evaluator.hpp"

namespace diagnosis::runs {

struct Normal {              // of one window
  Mat states_inverse_cross;  // what a change of the parameters does to the state
  Vec state_step;
  Mat state_gram, cross;  // of the state, in units of state_scale; with the parameters
  Vec state_scale, state_right;
  Mat gram;
  Vec score;
  Vec ss;
  Vec residual;                 // while blocks are asked for
  std::vector<Mat> block_gram;  // where blocks are asked for
  std::vector<Vec> block_score, block_ss;
};

struct WindowsPass {
  bool ok = false;
  std::vector<Normal> windows;
  Vec mean_square;
  double cost = 0, memory = 1;
};

// parts: blocks that each window is divided into; 0: none are asked for. The windows side by side, what they sum up to in order.
WindowsPass pass_over(Evaluator& evaluator, const std::vector<Window>& windows, const Vec* weights, bool slopes,
                      size_t parts = 0);

}  // namespace diagnosis::runs
