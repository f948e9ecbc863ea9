#include "firmware/warrant/score_tests.hpp"

namespace firmware {

#if FIRMWARE_WARRANT_NUMBERS > 0

namespace {

// Something has moved: where nothing has, there is nothing to test.
bool any_estimate(const Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const EstimateStatus status = estimates.parameters[k].status;
    if (status != EstimateStatus::kStale && status != EstimateStatus::kNoExcitation) return true;
  }
  return false;
}

}  // namespace

void ScoreTests::judge(int levels, Estimates& estimates) {
  if (!on_) return;
  sums_->flush();
  const bool judged =
      configuration_->calibrates_tests() && any_estimate(estimates) && test_->judge(*configuration_, *sums_, estimates);
  give_verdict(*configuration_, *sums_, *test_, {judged, levels}, estimates);
}

#endif

}  // namespace firmware
