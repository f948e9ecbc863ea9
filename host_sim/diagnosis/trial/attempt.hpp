// Candidates put beside a model and fitted with it.
#pragma once
#include <functional>

#include "../candidates/candidates.hpp"
#include "../fit/in_parallel.hpp"
#include "settle.hpp"

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
  bool no_sensors = false, unresolved = false;  // is_no_sensors(), is_unresolved_mode(): no cause either
};

// Where windows' states start: as fitted for the model beside, or (where that was far off) as measured.
enum class From { kBeside, kMeasured };
Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& candidates,
                const std::vector<std::vector<double>>& values, int steps, From from = From::kBeside);
// One that was screened; `all`: where a gentler shape of it is found when the best one does not converge; noise: its share of
// the squared residual.
Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                double noise);

// make(0), make(1), ... on the machine's cores, in their order.
template <typename Make>
std::vector<Attempt> side_by_side(size_t count, const Make& make) {
  std::vector<Attempt> tried(count);
  in_parallel(count, [&](size_t i, size_t) { tried[i] = make(i); });
  return tried;
}

// As many of the screened ones, side by side, in their order. One that got stuck is looked for further unless one that
// `stands`, or one that is known (`least`: its whole error), leaves less than half of what it promises.
using Stands = std::function<bool(const Attempt&)>;
std::vector<Attempt> attempts(const Task& task, const State& beside, const std::vector<Candidate>& all,
                              const std::vector<Screened>& list, double noise, double least, const Stands& stands = {});

// A candidate as it was fitted: with its shape, one term.
void keep_shape(const Model& fitted, Candidate& candidate);

}  // namespace diagnosis::runs
