// The balance of forces of every DOF in one record's guessed motion, as equations of a model's unknown numbers.
#pragma once
#include "../simulate/model.hpp"

namespace diagnosis::runs {

struct DofBalance {
  std::vector<Index> acting;  // indices into `unknown` of the numbers that act on it
  Mat rows;                   // samples x acting: what each makes of the balance, per unit
  Vec given;                  // what is left for them
};

constexpr Index kFirstBalanced = 2;  // sample; as many are left out at the end: rates and signs need neighbours

// unknown: indices into the model. Of every stride-th sample from the first balanced on, `count` in all.
std::vector<DofBalance> balances_of(const System& system, const Prepared& record, const Model& model,
                                    const std::vector<size_t>& unknown, Index stride, Index count);
}  // namespace diagnosis::runs
