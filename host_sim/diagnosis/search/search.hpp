// Which few effects, where: greedy with refined shapes, then swapping and pruning.
#pragma once
#include <vector>

#include "scoring.hpp"

namespace diagnosis {

struct SearchResult {
  std::vector<ActiveTerm> base;  // the rig file's terms, fitted alone
  Fit base_fit;
  std::vector<ActiveTerm> model;  // with the added terms
  Fit fit;
  std::vector<Found> added;                // with what each gains in the final model
  std::vector<std::vector<Found>> rivals;  // per added term: others that fit nearly as well in its place
};

constexpr size_t kMostTerms = 3;

// What one term more must explain of what a model's added terms do: more where a shape was not met, most where it is
// friction's.
double least_share(const std::vector<ActiveTerm>& model);

SearchResult search(Rows& rows, const CandidateBank& bank);

}  // namespace diagnosis
