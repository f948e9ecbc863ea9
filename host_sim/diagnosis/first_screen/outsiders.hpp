// Forces outside the vocabulary that leave a plain trace: a tone, a coefficient that changes with time, a force that
// repeats with the elongation. They are not named as causes: their presence makes a residual "unknown".
#pragma once
#include <string>

#include "../search/candidates.hpp"

namespace diagnosis {

struct Outsider {
  double score = 0;  // fall of chi-squared over the noise that remains
  double threshold = 60;
  std::string description;  // "a tone of 27.4 Hz on dof 1"
  double hertz = 0;         // of a tone
  int repeats_on = -1;      // the link with whose elongation it repeats; none: -1
  bool present() const { return score > threshold; }
};

// The strongest trace beside a fitted model.
Outsider strongest_outsider(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                            const Fit& fit);

}  // namespace diagnosis
