// The weighted least-squares fit over all levels, iterated: the weights come from the scatter of the residuals, the
// residuals from the last parameters. Start weights by motion energy, then twice by measured scatter. Each pass solves
// for a change of the parameters from the residuals that the last one leaves, so that what rounding costs one pass the
// next one finds; the first is done over for that, with its equations as they are.
#pragma once
#include "firmware/identification/fit/identifiability.hpp"
#include "firmware/identification/fit/whitening.hpp"

namespace firmware {

class WeightedFit {
 public:
  void solve(const EquationList& list, const BatchTable& table);

  const Scaled* parameters() const { return parameters_; }
  const RowLayout& layout() const { return table_->layout; }
  const NormalEquations& equations() const { return equations_; }
  const Identifiability& identifiability() const { return identifiability_; }  // of the first pass
  // Of the last pass.
  const Whitening& whitening(int level, int e) const { return whitening_[level][e]; }
  // The level's columns with the residuals that the solution leaves.
  LevelColumns& load_level(int level, bool with_controls = true);
  // The equation's rows of the level that is loaded.
  ReducedRows& reduce(const Whitening& whitening, int e, bool with_controls);
  // Room for one vector of the unknowns, of whoever works with the fit: on the stack it would be the largest part of a frame.
  Scaled* vector() { return vector_; }
  // Root mean square over all equations of the noise of a row relative to its energy.
  const Scaled& relative_noise() const { return relative_noise_; }
  bool all_measured() const { return all_measured_; }

 private:
  void start_weights();
  void measure_level(int l);
  void take_unmeasured(int l);
  void add_equation(int l, int e);
  void begin_pass(bool new_equations);
  void end_pass();
  void start_pass(bool new_equations);
  void weighted_pass();
  Scaled motion_of(int e) const;

  const EquationList* list_ = nullptr;
  const BatchTable* table_ = nullptr;
  Scaled relative_noise_, noise_sum_;
  int noise_count_ = 0;
  bool all_measured_ = false;
  bool new_equations_ = true;  // else the right-hand sides alone are new
  Scaled parameters_[kMaxUnknowns];
  // Deviation of a row per (integral of v^2), for levels without own scatter; of a pass: sum of their squares, and how
  // many.
  Scaled relative_deviation_[kMaxEquations], deviation_sum_[kMaxEquations];
  int deviation_count_[kMaxEquations];
  Whitening whitening_[kMaxLevels][kMaxEquations];
  NormalEquations equations_;
  Identifiability identifiability_;
  LevelColumns level_;
  ReducedRows reduced_;
  Scaled vector_[kMaxUnknowns];
};

}  // namespace firmware
