// Which few effects, where: greedy with refined shapes, then swapping and pruning.
#pragma once
#include <vector>

#include "candidates.hpp"

namespace diagnosis {

struct Found {
  Candidate candidate;
  Gain gain;
  double score = 0;  // (gain - penalty) / max(1, chi2 / dof)
};

struct SearchResult {
  std::vector<ActiveTerm> base;    // the rig file's terms, fitted alone
  Fit base_fit;
  std::vector<ActiveTerm> model;   // with the added terms
  Fit fit;
  std::vector<Found> added;        // with what each gains in the final model
  std::vector<std::vector<Found>> rivals;  // per added term: others that fit nearly as well in its place
};

constexpr size_t kMostTerms = 3;

// Candidates beside a fitted model, best first, one per kind and place, the leading ones with refined shape.
std::vector<Found> ranked(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                          const Fit& fit, size_t refined);
SearchResult search(Rows& rows, const CandidateBank& bank);

}  // namespace diagnosis
