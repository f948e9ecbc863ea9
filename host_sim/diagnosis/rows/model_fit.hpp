// Least squares of the present model over the weighted rows, and what one more term would gain.
#pragma once
#include <vector>

#include "projection.hpp"

namespace diagnosis {

// A fit; its projection shows at once what one more column would change.
struct Fit {
  double chi2 = 0;  // squared weighted residual
  double dof = 1;   // real rows minus fitted values
  double ratio() const { return chi2 / dof; }
  double cost = 0;  // chi-squared and what the width of the weights costs: compares shapes of friction
  std::shared_ptr<const Projection> projection;
};

// Fits the unknown values in place (value and std; std is widened where the residual is beyond noise).
Fit fit_model(const Rows& rows, std::vector<ActiveTerm>& model);

// Fits and updates the rows' covariance until both agree.
Fit settle(Rows& rows, std::vector<ActiveTerm>& model, int rounds);

struct Candidate {
  std::shared_ptr<const Column> column;
  std::vector<std::shared_ptr<const Column>> companions;  // fitted with it, free in sign
  const Term& term() const { return column->term; }
  double coefficient_sign = 0;  // physical sign of the coefficient; 0: either
  double penalty = 0;           // chi-squared that its shape parameters may win by chance
  double threshold = 0;         // of chi-squared
  int host = -1;                // active term in whose place it acts, or -1
  double host_sign = 1;
  bool fixed = false;  // its coefficient is host_sign times the host's known value
  double doubt = 0;    // standard deviation of its coefficient beyond what the rows' noise makes
  // What chi-squared must fall by where the rows know the coefficient with `std`.
  double needed(double std) const { return doubt > 0 ? threshold * (1 + doubt * doubt / (std * std)) : threshold; }
};

struct Gain {
  double chi2 = 0;  // how much chi-squared falls
  double coefficient = 0;
  double std = 0;
};
Gain gain_of(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit, const Candidate& candidate);
// The same for many, place by place: much faster than one by one.
std::vector<Gain> gains_of(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit,
                           const std::vector<Candidate>& candidates);

// The model with the candidate, its companions last.
std::vector<ActiveTerm> joined(const std::vector<ActiveTerm>& model, const Candidate& candidate, const Gain& gain);
void remove_term(std::vector<ActiveTerm>& model, size_t index);  // with its companions
// The model's terms over the motion of other rows.
std::vector<ActiveTerm> on_rows(const Rows& rows, std::vector<ActiveTerm> model);
// The model without the added term of this kind and place.
std::vector<ActiveTerm> without_added(std::vector<ActiveTerm> model, const Term& term);

}  // namespace diagnosis
