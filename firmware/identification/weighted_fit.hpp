// The weighted least-squares fit over all levels, iterated: the weights come from the scatter of the residuals, the
// residuals from the last parameters. Three passes: start weights by motion energy, then twice by measured scatter.
#pragma once
#include "firmware/identification/givens.hpp"
#include "firmware/identification/identifiability.hpp"
#include "firmware/identification/whitening.hpp"

namespace firmware {

class WeightedFit {
 public:
  void solve(const EquationList& list, const BatchTable& table);

  const Scaled* parameters() const { return parameters_; }
  const TriangularFactor& factor() const { return factor_; }
  const Identifiability& identifiability() const { return identifiability_; }  // of the first pass
  // Of the last pass.
  const Whitening& whitening(int level, int e) const { return whitening_[level][e]; }
  LevelObservables& load_level(int level);
  // Root mean square over all equations of the noise of a row relative to its energy.
  Scaled relative_noise() const { return relative_noise_; }
  bool all_measured() const { return all_measured_; }

 private:
  void start_weights();
  void measure_weights();
  void fill_unmeasured();
  void fit();

  const EquationList* list_ = nullptr;
  const BatchTable* table_ = nullptr;
  Scaled parameters_[kMaxUnknowns];
  Scaled
      relative_deviation_[kMaxEquations];  // deviation of a row per (integral of v^2), for levels without own scatter
  Whitening whitening_[kMaxLevels][kMaxEquations];
  Scaled relative_noise_;
  bool all_measured_ = false;
  TriangularFactor factor_;
  Identifiability identifiability_;
  LevelObservables level_;
  int loaded_ = -1;  // level that level_ holds
};

}  // namespace firmware
