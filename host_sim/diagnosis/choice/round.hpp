// The cause that does best beside a model, or two that help only together.
#pragma once
#include "../trial/singles.hpp"
#include "choice.hpp"

namespace diagnosis::runs {

struct Round {
  Attempt best;
  bool found = false;
  std::vector<Candidate> passed_over;  // others that leave about as little as `best`; as they were fitted
  bool stuck = false;  // the model beside had settled in a valley of its error: `unstuck` is it in a lower one
  State unstuck;
};
// already: causes named before; left: what the model leaves; noise: the share of its squares that looks like it. Leaves
// the screen in `choice`. worth: of each number that a cause has more than a simpler one, as a factor of the squared error
// that it has to save.
Round round_of(const Task& task, const State& now, size_t already, const Left& left, double noise, double worth,
               Choice& choice);

// By how much the unknown numbers of a rig, and those of the other causes, are other beside a rival than beside the cause named: all that
// `rest`, to which one or the other was added, has.
std::vector<Move> moves_between(const Task& task, const Model& rest, const Model& named, const Model& rival);

// The named causes again, each against every other candidate in its place beside the rest: drops one that is not needed
// any more, puts a better one in its place, and lists those that do as well.
void weigh_rivals(const Task& task, const std::function<void(double)>& progress, Choice& choice);

}  // namespace diagnosis::runs
