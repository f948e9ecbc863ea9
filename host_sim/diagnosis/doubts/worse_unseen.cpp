#include "worse_unseen.hpp"

#include <algorithm>
#include <iterator>

namespace diagnosis::runs {
namespace {

// Two free runs of one rig that begin a little apart miss a third more or less.
constexpr double kPlainlyWorse = 1.5;

}  // namespace

void reject_what_simulates_worse(const rig_file::RigModel& rig, Diagnosis& d) {
  const auto of_rig = [](const Cause& c) { return !c.taken_out; };
  if (std::none_of(d.causes.begin(), d.causes.end(), of_rig) || d.baseline.holdout_nrmse_percent.empty()) return;
  if (!(d.extended.most_missed_percent() > kPlainlyWorse * d.baseline.most_missed_percent())) return;
  std::copy_if(d.causes.begin(), d.causes.end(), std::back_inserter(d.rejected), of_rig);
  d.causes.erase(std::remove_if(d.causes.begin(), d.causes.end(), of_rig), d.causes.end());
  d.ambiguous_with.clear();
  d.extended = d.baseline, d.extended_rig = rig;
  d.extended_misfit = d.baseline_misfit;
  d.verdict = d.causes.empty() ? Verdict::kUnknown : Verdict::kPartly;
  std::fill(d.gain.begin(), d.gain.end(), 1.0);
  std::fill(d.remainder_percent.begin(), d.remainder_percent.end(), 100.0);
}

}  // namespace diagnosis::runs
