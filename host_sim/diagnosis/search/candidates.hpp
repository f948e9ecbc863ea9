// Every effect that could be missing, at every place, with its shapes on a grid.
#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "../rows/model_fit.hpp"

namespace diagnosis {

// The rig file's own terms as the model to start from.
std::vector<ActiveTerm> base_model(const Rows& rows);

class CandidateBank {
 public:
  explicit CandidateBank(const Rows& rows);
  // Those that make sense beside the present model (no second copy of a term, hosts found).
  std::vector<Candidate> beside(const std::vector<ActiveTerm>& model) const;
  // Terms that these records cannot show at any strength, which is why they are not among the candidates.
  std::vector<Term> unseen(const std::vector<ActiveTerm>& model) const;
  // Those that are not among the candidates because another explains as much: an effect of that strength shows all the same.
  std::vector<Candidate> seen_as_rivals(const std::vector<ActiveTerm>& model) const;
  // One candidate of the same kind and place with another shape.
  Candidate reshaped(const Candidate& candidate, double shape, double shape2) const;
  // The candidate that an added term came from, beside a model without it.
  Candidate again(const Term& term, const std::vector<ActiveTerm>& model) const;
  // Range of the shape parameters of a kind at a place.
  struct Range {
    double low, high;
  };
  Range range(const Term& term) const;
  Range second_range(const Term& term) const;
  double slide_s(const Term& presliding) const {
    return presliding.shape / extent(presliding.link).w_rms;
  }  // over its length
  static bool has_shape(const Term& term);
  // Whether the coefficient alone does not describe it: a shape, or a delay beyond its first order.
  static bool bends(const Term& term) { return has_shape(term) || term.kind == Kind::kForceDelay; }
  static bool friction_shape(Kind kind) { return kind == Kind::kStribeck || kind == Kind::kPresliding; }

  // Fall of chi-squared that names an effect where nothing else makes it stricter: so high that chance passes it on any of the
  // rig's kinds and places in one of 500 records. Small rigs have fewer of them, and show weaker effects.
  double threshold() const { return threshold_; }
  // Times what the threshold of a kind is where it stands on motion that no second channel bears out, or is integrated.
  double strictness(Kind kind) const;
  // Added to the threshold of an effect that shares a DOF with a link of strong friction.
  double reversal_doubt(const std::vector<ActiveTerm>& model, const Term& term) const;

 private:
  using Columns = std::vector<std::shared_ptr<const Column>>;
  void add(const Term& term, Columns& columns) const;
  std::vector<Term> companions_of(const Term& term) const;  // fitted with it: a hum's sine, a resonance's start, ...
  struct Extent {
    double u_peak = 0, u_rms = 0, w_rms = 0;
  };
  Extent extent(int link) const;  // the widest over the records
  double duration_s() const {
    return static_cast<double>(rows_.records().front().samples) * rows_.records().front().period_s;
  }
  void add_effects(int link, Columns& columns) const;
  const Columns& effects_of_unlisted(int link) const;  // made when they are first asked for
  void add_dof(int dof);
  double chance_threshold() const;
  bool observable(const std::vector<ActiveTerm>& model, const Term& term) const;
  bool shows_as_rival(const std::vector<ActiveTerm>& model, const Term& term) const;
  bool prepare(const std::vector<ActiveTerm>& model, Candidate& candidate) const;
  mutable std::map<const Column*, Columns> partner_;  // companions of those on the grid
  const Rows& rows_;
  double highest_Hz_ = 0;  // of a hidden resonance
  double threshold_ = 0;
  Columns columns_;
  mutable std::map<int, Columns> unlisted_;  // per link that the rig file does not list
};

}  // namespace diagnosis
