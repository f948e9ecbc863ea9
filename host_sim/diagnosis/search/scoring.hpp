// How well a candidate fits beside a model, and with which shape.
#pragma once
#include <vector>

#include "candidates.hpp"

namespace diagnosis {

struct Found {
  Candidate candidate;
  Gain gain;
  double score = 0;  // (gain - penalty) / max(1, chi2 / dof)
};

// Which shape parameters change together.
enum class Axis { kFirst, kSecond, kBoth };
// The term with these multiplied by exp(logarithm).
Term moved(const Term& term, Axis axis, double logarithm);

struct Scorer {
  const Rows& rows;
  const CandidateBank& bank;
  const std::vector<ActiveTerm>& model;
  const Fit& fit;

  Found of(const Candidate& c) const { return scored(c, gain_of(rows, model, fit, c)); }
  Found scored(const Candidate& c, const Gain& gain) const;
  Found refined(const Found& found) const;   // from a shape on the grid to the best nearby
  Found polished(const Found& found) const;  // a closer look around a shape that is nearly right

  // Brent's minimum on the logarithm of shape parameters within a factor of their present value.
  Found along(const Found& start, Axis axis, double factor, int steps) const;

 private:
  Found bristles(const Found& found, double factor) const;  // Dahl's or LuGre's, whichever scores
  Found delayed(const Found& found) const;
};

// A model whose values a rig can have: no correction as large as what it corrects.
bool plausible(const std::vector<ActiveTerm>& model);

// Candidates beside a fitted model, best first, one per kind and place, the leading ones with refined shape.
std::vector<Found> ranked(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                          const Fit& fit, size_t refined);

}  // namespace diagnosis
