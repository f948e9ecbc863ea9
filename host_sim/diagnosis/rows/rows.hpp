// The equation error of every DOF in Fourier rows, each bin weighed with its own covariance over the DOFs:
// Sigma = S_force + D P D^H, D = K - w^2 M + j w C of the model as it stands, P the error of the fused displacements.
#pragma once
#include <memory>
#include <vector>

#include "information.hpp"

namespace diagnosis {

// A term's force, transformed under the inner weight; one spectrum per record, rows first_bin .. last_bin.
struct Column {
  Term term;
  std::vector<Spectrum> spectra;
  // the linear coefficients that dissipate, store or accelerate as the term does, per unit coefficient
  double stiffness = 0, viscous = 0, mass = 0;
};

// A term of the present model.
struct ActiveTerm {
  Term term;
  std::shared_ptr<const Column> column;
  bool known = false;  // value is given, not fitted
  bool added = false;  // not in the rig file
  int companion = -1;  // belongs to this active term and leaves with it
  int host = -1;       // shares the coefficient of this active term (times host_sign): acts in its place
  double host_sign = 1;
  double value = 0, std = 0;
  double shape_std = 0, shape2_std = 0;              // 0: not fitted beside the coefficients
  bool alike = false;                                // the records show it and others together only
  std::shared_ptr<const std::vector<Series>> force;  // per record, with coefficient one; filled by Rows::prepare()
};

// A term's coefficient: that of its host where it has one.
inline double acting_value(const std::vector<ActiveTerm>& model, const ActiveTerm& t) {
  return t.host >= 0 ? t.host_sign * model[static_cast<size_t>(t.host)].value : t.value;
}

// Transform of a force over time under the inner weight, rows first_bin .. last_bin.
Spectrum row_spectrum(const FusedRecord& record, const Series& force);

using Weights = std::vector<Information>;  // per record

class Rows {
 public:
  Rows(const System& system, const std::vector<FusedRecord>& records);
  std::shared_ptr<const Column> column(const Term& term) const;
  // Fills in what a term that joined the model lacks.
  void prepare(ActiveTerm& term) const;
  // How far from a reversal of the rate friction is taken as uncertain. Narrow: its shape shows. Wide: what reversals
  // leave over looks like no other effect.
  enum class Reversals { kNarrow, kWide };
  Reversals reversals() const { return reversals_; }
  // As long as one lives, the rows look at reversals its way (from the next settle() on).
  class Look {
   public:
    Look(Rows& rows, Reversals reversals) : rows_(rows), before_(rows.reversals_) { rows.reversals_ = reversals; }
    ~Look() { rows_.reversals_ = before_; }
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;

   private:
    Rows& rows_;
    Reversals before_;
  };
  // The friction near velocity reversals, from the balance of the model (stick.cpp).
  void hold_stuck(const std::vector<ActiveTerm>& model);
  // Sets the weights from the model's present values.
  void weight(const std::vector<ActiveTerm>& model);
  std::shared_ptr<const Weights> weights() const { return weights_; }
  Place place(const Term& term) const { return place_of_force(system_, term); }
  // What the motion needs beyond the known forces: measured force less the friction held near reversals, per record.
  std::vector<Balance> force() const;
  Eigen::Index size() const { return size_; }    // real rows
  double absorbed() const { return absorbed_; }  // how much chi-squared hold_stuck() takes up, were it all noise
  // Logarithm of the determinant of the rows' covariance: what a model pays in likelihood for what it leaves open.
  double log_determinant() const { return log_determinant_; }
  const LinkMotion& link(size_t record, size_t link) const { return links_[record][link]; }
  const System& system() const { return system_; }
  const std::vector<FusedRecord>& records() const { return records_; }
  bool has_force(size_t dof) const;
  bool absolute() const;   // displacements are known with their constant
  bool coarse() const;     // of a record a channel takes few values
  bool redundant() const;  // every DOF has two channels of motion or more
  // Per record and DOF the bin that explains most of a residual.
  std::vector<Tone> loudest_tones(const std::vector<Balance>& residual) const;

 private:
  Series force_of(const Term& term, size_t record) const;  // with coefficient one
  Eigen::Index bins(size_t record) const { return records_[record].last_bin + 1 - records_[record].first_bin; }
  const System& system_;
  const std::vector<FusedRecord>& records_;
  std::vector<std::vector<LinkMotion>> links_;
  std::vector<std::vector<Spectrum>> force_;  // [record][dof]
  std::vector<std::vector<Spectrum>> held_;   // [record][link]: friction beyond Coulomb's; empty where none
  std::vector<std::vector<double>> doubt_;    // [record][link]: variance per sample of what is uncertain in it
  std::shared_ptr<const Weights> weights_;    // shared with the fits made under them
  Eigen::Index size_ = 0;
  double absorbed_ = 0, log_determinant_ = 0;
  Reversals reversals_ = Reversals::kNarrow;
};

}  // namespace diagnosis
