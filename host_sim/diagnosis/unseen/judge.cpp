#include "judge.hpp"

#include <algorithm>
#include <cmath>

#include "../record/sharpen.hpp"

namespace diagnosis {
namespace {

constexpr int kSteps = 4;        // of a simulation per sample
constexpr double kWorse = 0.06;  // of the error's square: less is no difference
constexpr double kMuchWorse = 0.3;
constexpr double kBeyondNoise = 9;  // of the noise's square: such an error is not noise

// Square of the noise of a DOF's fused displacement, in the units of run_errors(), over so many samples.
double noise_square(const FusedRecord& f, const DofMotion& m, Eigen::Index from, Eigen::Index length) {
  const Eigen::Index top = std::min(m.variance.size(), f.last_bin + f.last_bin / 2);
  const Series x = m.x.segment(from, length);
  const double power = (x.array() - x.mean()).square().mean();
  return 2 * m.variance.head(top).sum() / static_cast<double>(f.samples) * static_cast<double>(length) /
         std::max(power, 1e-300);
}

}  // namespace

Judge::Judge(const System& system, const std::vector<FusedRecord>& full, const std::vector<FusedRecord>& early,
             std::vector<FusedRecord> unseen, double early_share)
    : system_(system), full_(full), early_(early), unseen_(std::move(unseen)), early_share_(early_share) {}

std::vector<ActiveTerm> Judge::fitted(const std::vector<ActiveTerm>& model) const {
  Rows rows(system_, early_);
  std::vector<ActiveTerm> copy = on_rows(rows, model);
  settle(rows, copy, 2);
  return copy;
}

std::vector<Judge::Span> Judge::spans(const std::vector<FusedRecord>& records, double from_share) const {
  std::vector<Span> list;
  for (const FusedRecord& f : records) {
    const Eigen::Index n = static_cast<Eigen::Index>(f.samples);
    const Eigen::Index ramp = static_cast<Eigen::Index>((f.outer.weight.array() < 1).count() / 2 + 8);
    list.push_back({f, std::max(ramp, static_cast<Eigen::Index>(from_share * static_cast<double>(n))), n - ramp});
  }
  return list;
}

HoldoutScore Judge::over(const std::vector<FusedRecord>& records, const std::vector<ActiveTerm>& model,
                         double from_share) const {
  HoldoutScore total;
  total.nrmse_percent.assign(system_.dofs(), 0.0), total.mse_percent = total.velocity_percent = total.nrmse_percent;
  for (const Span& s : spans(records, from_share)) {
    const HoldoutScore one = score_free_run(system_, model, s.record, s.from, s.to);
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

// With errors e of the one and e + d of the other the squares differ by d'd + 2 e'd. Were the one right, e would be noise
// that knows nothing of d: then e'd has no mean, and its variance follows from the power of both, frequency by frequency.
// Where e is far beyond noise there is no such excuse.
bool Judge::clearly_worse(const std::vector<ActiveTerm>& model, const std::vector<ActiveTerm>& other) const {
  double better = 0, variance = 0, square = 0, noise = 0;
  const std::vector<Span> list = unseen_.empty() ? spans(full_, early_share_) : spans(unseen_, 0);
  for (const Span& s : list) {
    const Series mine = run_errors(system_, model, s.record, s.from, s.to, kSteps);
    const Series others = run_errors(system_, other, s.record, s.from, s.to, kSteps);
    if (others.size() == 0) continue;
    if (mine.size() == 0) return true;  // does not stay finite
    const Eigen::Index length = s.to - s.from, dofs = static_cast<Eigen::Index>(system_.dofs());
    const Fourier fourier(static_cast<size_t>(length));
    Spectrum cross = Spectrum::Zero(fourier.bins());
    for (Eigen::Index j = 0; j < dofs; ++j) {
      const Series e = mine.segment(j * length, length), d = others.segment(j * length, length) - e;
      better += d.squaredNorm() + 2 * e.dot(d), square += e.squaredNorm();
      noise += noise_square(s.record, s.record.motion[static_cast<size_t>(j)], s.from, length);
      cross += fourier.forward(e).conjugate().cwiseProduct(fourier.forward(d));
    }
    variance += 8 * cross.squaredNorm() / std::pow(static_cast<double>(length), 2);
  }
  if (square > kBeyondNoise * noise && better < -kMuchWorse * square) return true;
  return better < -kWorse * square && better < -2 * std::sqrt(variance);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace diagnosis
