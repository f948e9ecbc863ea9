// A core for a rig, and its return to the state before the first sample.
#include "firmware/estimator_core.hpp"

namespace firmware {
namespace {

// The displacement's sums serve masses, springs and what else is conservative; where all of those are known nothing reads
// them.
int weights_needed(const CoreConfiguration& configuration, CoreDetail detail) {
  if (detail == CoreDetail::kPlain) return 1;
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown >= 0 && is_conservative(configuration.terms[t].kind)) return 3;
  return 2;
}

// Is any signal more than a copy of what is measured?
bool needs_filters(const CoreConfiguration& configuration) {
  for (const auto& node : configuration.signals)
    for (const SignalConfiguration& signal : node)
      if (signal.available && (signal.half_length > 0 || signal.tap[0].raw != 0)) return true;
  return configuration.asks_for_filtered_sign();
}

ClearSigns clear_signs(const CoreConfiguration& configuration, const EnergySums& sums) {
  ClearSigns signs;
  for (int l = 0; l < configuration.link_count; ++l) signs.link[l] = sums.takes_clear_sign(l);
  for (int i = 0; i < configuration.dof_count; ++i) signs.dof[i] = sums.leaves_samples_out(i);
  signs.filtered = configuration.filters_sign();
  return signs;
}

}  // namespace

EstimatorCore::EstimatorCore(const CoreConfiguration& configuration, CoreDetail detail)
    : configuration_(configuration) {
  conditioning_->configure(configuration);
  const int weights = weights_needed(configuration, detail);
  fits_ = weights <= kWeights && (kDerivesSignals || !needs_filters(configuration));
  stages_->sums.configure(configuration, fits_ ? weights : kWeights);
  tests_.configure(configuration, detail == CoreDetail::kFull, stages_->sums.effect_units(),
                   clear_signs(configuration, stages_->sums));
  tests_work_ = tests_.on();
  reset();
}

void EstimatorCore::reset() {
  corrections_->clear();
  conditioning_->shift_nothing();
  forget_levels();
  firmware::clear(estimates_);
  estimates_.unknown_count = configuration_.unknown_count;
  health_ = CoreHealth{};
  sequence_known_ = false;
}

void EstimatorCore::forget_levels() {
  collector_.clear(configuration_, stages_->sums.layout());
  tests_.clear();
  corrections_->apply(configuration_, *conditioning_);
  conditioning_->restart();
  stages_->sums.restart();
  filled_ = 0;
  level_samples_ = units_ = 0;
  closing_ = forgets_ = starved_ = false;
  filled_columns_ = 0;
}

}  // namespace firmware
