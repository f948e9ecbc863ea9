#include "firmware/warrant/scores/score_test.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

constexpr int kLeastStretches = 8;  // of the whole record

}  // namespace

bool ScoreTest::judge(const CoreConfiguration& configuration, const ScoreSums& sums, const Estimates& estimates) {
  configuration_ = &configuration;
  sums_ = &sums;
  forget();
  const ScoreTable& table = sums.table();
  stretches_ = table.stretches();
  const ProbePlan& plan = sums.plan();
  for (int j = 0; j < plan.probe_count; ++j, report_work(60)) score_[j] = ProbeScore{};
  if (stretches_ < kLeastStretches) return false;
  unknowns_ = configuration.unknown_count;
  levels_ = 0;
  for (bool& blind : blind_) blind = false;
  int last = -1;
  samples_ = Scaled{};
  for (int s = 0; s < stretches_; ++s) {
    const Stretch& stretch = table.stretch(s);
    if (stretch.level != last && levels_ < kMaxLevels) level_begin_[levels_++] = static_cast<uint16_t>(s);
    last = stretch.level;
    level_begin_[levels_] = static_cast<uint16_t>(s + 1);
    level_of_[s] = static_cast<uint8_t>(levels_ - 1);
    report_work(150);
    samples_ += Scaled::from_int(static_cast<int64_t>(stretch.blocks) * kBlockSamples);
  }
  // What waits for its block to fill, at a level's two ends, is not left out.
  const int64_t waiting = static_cast<int64_t>(levels_) * kProbeSamples;
  const Scaled offered = Scaled::from_int(static_cast<int64_t>(sums.offered()) - waiting);
  seen_root_ = samples_ < offered ? sqrt(samples_ / offered) : kScaledOne;
  for (int k = 0; k < unknowns_; ++k) {
    parameter_[k] = estimates.parameters[k].value;
    tested_[k] = CoefficientTest{};
  }
  settle(estimates);
  for (int j = 0; j < plan.probe_count; ++j) {
    own_square_[j] = Scaled{};
    test(j);
  }
  for (int j = 0; j < plan.probe_count; ++j) judge_size(j);
  name();
  find_named_bends();
  return true;
}

}  // namespace firmware
