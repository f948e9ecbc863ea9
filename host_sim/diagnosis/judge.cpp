#include "judge.hpp"

#include <algorithm>
#include <cmath>

#include "sharpen.hpp"

namespace diagnosis {

Judge::Judge(const System& system, const std::vector<FusedRecord>& full, const std::vector<FusedRecord>& early,
             std::vector<FusedRecord> unseen, double early_share)
    : system_(system), full_(full), early_(early), unseen_(std::move(unseen)), early_share_(early_share) {}

std::vector<ActiveTerm> Judge::fitted(const std::vector<ActiveTerm>& model) const {
  Rows rows(system_, early_);
  std::vector<ActiveTerm> copy;
  for (const ActiveTerm& t : model) {
    ActiveTerm term = t;
    term.column = rows.column(t.term);
    term.force.reset();
    copy.push_back(term);
  }
  settle(rows, copy, 2);
  return copy;
}

HoldoutScore Judge::over(const std::vector<FusedRecord>& records, const std::vector<ActiveTerm>& model, double from_share) const {
  HoldoutScore total;
  total.nrmse_percent.assign(system_.dofs(), 0.0), total.mse_percent = total.velocity_percent = total.nrmse_percent;
  for (const FusedRecord& f : records) {
    const Eigen::Index n = static_cast<Eigen::Index>(f.samples);
    const Eigen::Index ramp = static_cast<Eigen::Index>((f.outer.weight.array() < 1).count() / 2 + 8);
    const Eigen::Index from = std::max(ramp, static_cast<Eigen::Index>(from_share * static_cast<double>(n)));
    const HoldoutScore one = score_free_run(system_, model, f, from, n - ramp);
    for (size_t j = 0; j < system_.dofs(); ++j) {
      total.nrmse_percent[j] += std::pow(one.nrmse_percent[j], 2) / static_cast<double>(records.size());
      total.velocity_percent[j] += std::pow(one.velocity_percent[j], 2) / static_cast<double>(records.size());
      total.mse_percent[j] += one.mse_percent[j] / static_cast<double>(records.size());
    }
  }
  for (double& v : total.nrmse_percent) v = std::sqrt(v);
  for (double& v : total.velocity_percent) v = std::sqrt(v);
  return total;
}

HoldoutScore Judge::score(const std::vector<ActiveTerm>& model) const {
  return unseen_.empty() ? over(full_, model, early_share_) : over(unseen_, model, 0);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace diagnosis
