// The equation error of every DOF in Fourier rows, whitened with its own covariance per frequency:
// Sigma = S_force + D P D^H, D = K - w^2 M + j w C of the model as it stands, P the error of the fused displacements.
#pragma once
#include <vector>

#include "terms.hpp"

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
  Column column;
  bool known = false;   // value is given, not fitted
  bool added = false;   // not in the rig file
  int companion = -1;   // belongs to this active term and leaves with it
  int host = -1;        // shares the coefficient of this active term (times host_sign): acts in its place
  double host_sign = 1;
  double value = 0, std = 0;
  std::vector<Series> force;  // per record, with coefficient one; filled by Rows::prepare()
};

// Transform of a force over time under the inner weight, rows first_bin .. last_bin.
Spectrum row_spectrum(const FusedRecord& record, const Series& force);

struct Tone {
  double hertz = 0, gain = 0;
  int dof = 0;
};

class Rows {
 public:
  Rows(const System& system, const std::vector<FusedRecord>& records);
  Column column(const Term& term) const;
  // Fills in what a term that joined the model lacks.
  void prepare(ActiveTerm& term) const;
  // The friction near velocity reversals, from the balance of the model (stick.cpp).
  void hold_stuck(const std::vector<ActiveTerm>& model);
  // Sets the covariance from the model's present values.
  void weight(const std::vector<ActiveTerm>& model);
  // Real rigs differ from any model by more than sensor noise: widens the covariance, per frequency, to the residual
  // (whitened by the present one) that a fit left over; `freedom` is the share of rows that the fit did not use up.
  void colour(const Series& residual, double freedom);
  Series whitened(const Column& column) const;
  Series whitened_force() const;
  Eigen::Index size() const { return size_; }
  double absorbed() const { return absorbed_; }  // how much chi-squared hold_stuck() takes up, were it all noise
  const LinkMotion& link(size_t record, size_t link) const { return links_[record][link]; }
  const System& system() const { return system_; }
  const std::vector<FusedRecord>& records() const { return records_; }
  bool has_force(size_t dof) const;
  bool absolute() const;  // displacements are known with their constant
  // Per record and DOF the bin that explains most of a whitened residual.
  std::vector<Tone> loudest_tones(const Series& residual) const;

 private:
  using Matrix = Eigen::MatrixXcd;
  void place(const Matrix& pattern, const Spectrum& spectrum, Eigen::Index offset, Series& out) const;
  const System& system_;
  const std::vector<FusedRecord>& records_;
  std::vector<std::vector<LinkMotion>> links_;
  std::vector<std::vector<Spectrum>> force_;       // [record][dof]
  std::vector<std::vector<Matrix>> patterns_;      // [record][links, then dofs]: dofs x bins, whitened incidence
  std::vector<std::vector<Spectrum>> held_;        // [record][link]: friction beyond Coulomb's; empty where none
  std::vector<std::vector<double>> doubt_;         // [record][link]: variance per sample of what is uncertain in it
  std::vector<Series> inflation_;                  // [record]: factor of the covariance per row bin, 1 or more
  Eigen::Index size_ = 0;
  double absorbed_ = 0;
};

}  // namespace diagnosis
