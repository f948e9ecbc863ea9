// From channels to windowed spectra.
#include <algorithm>
#include <cmath>

#include "motion.hpp"

namespace diagnosis {
namespace {

using host_sim::Quantity;
constexpr Quantity kOrder[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};

// Running integral by trapezoids, freed of what changes slower than about a second (its constant is unknown).
Series integral(const Series& values, double period_s) {
  const Eigen::Index n = values.size(), half = std::min<Eigen::Index>(n / 4, static_cast<Eigen::Index>(0.5 / period_s) + 1);
  Series sum(n);
  sum[0] = 0;
  for (Eigen::Index i = 1; i < n; ++i) sum[i] = sum[i - 1] + 0.5 * period_s * (values[i] + values[i - 1]);
  for (int pass = 0; pass < 2; ++pass) {
    Series total(n + 1);
    total[0] = 0;
    for (Eigen::Index i = 0; i < n; ++i) total[i + 1] = total[i] + sum[i];
    Series mean(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index reach = std::min({half, std::max<Eigen::Index>(i, 1), std::max<Eigen::Index>(n - 1 - i, 1)});
      const Eigen::Index low = std::max<Eigen::Index>(i - reach, 0), high = std::min(i + reach, n - 1);
      mean[i] = (total[high + 1] - total[low]) / static_cast<double>(high + 1 - low);
    }
    sum -= mean;
  }
  return sum;
}

Series derivative_of(const Series& values, double period_s) {
  const Eigen::Index n = values.size();
  Series out = Series::Zero(n);
  for (Eigen::Index i = 1; i + 1 < n; ++i) out[i] = (values[i + 1] - values[i - 1]) / (2 * period_s);
  return out;
}

DofSpectra transform(const host_sim::Record& record, int dof, const FusedRecord& f) {
  DofSpectra s;
  std::array<Series, 3> y;
  for (size_t q = 0; q < 3; ++q) {
    const host_sim::Channel* c = record.find(kOrder[q], dof);
    if (!c) continue;
    s.measured[q] = true;
    s.channel[q] = c->name;
    y[q] = Series::Map(c->values.data(), static_cast<Eigen::Index>(f.samples));
  }
  if (!s.any()) return s;
  // what is not measured is needed inside the ramps only
  if (!s.measured[1]) y[1] = s.measured[0] ? derivative_of(y[0], f.period_s) : integral(y[2], f.period_s);
  if (!s.measured[0]) y[0] = integral(y[1], f.period_s);
  const Ramp& g = f.outer;
  if (s.measured[0]) s.z[0] = f.fourier->forward(g.weight.cwiseProduct(y[0]));
  if (s.measured[1]) s.z[1] = f.fourier->forward(g.weight.cwiseProduct(y[1]) + g.slope.cwiseProduct(y[0]));
  if (s.measured[2])
    s.z[2] = f.fourier->forward(g.weight.cwiseProduct(y[2]) + 2 * g.slope.cwiseProduct(y[1]) + g.bend.cwiseProduct(y[0]));
  return s;
}

// So few different values that rounding is no noise of its own.
bool coarse(const host_sim::Channel& c) {
  std::vector<double> values = c.values;
  std::sort(values.begin(), values.end());
  return static_cast<size_t>(std::unique(values.begin(), values.end()) - values.begin()) < values.size() / 3;
}

}  // namespace

Complex derivative(double omega, int quantity) {
  return quantity == 0 ? Complex(1, 0) : quantity == 1 ? Complex(0, omega) : Complex(-omega * omega, 0);
}

FusedRecord read_record(const rig_file::RigModel& rig, const host_sim::Record& record, double top_of_band) {
  FusedRecord f;
  f.file = record.file;
  f.samples = fast_length(record.samples());
  f.period_s = record.sample_period_s;
  if (f.samples < 400)
    throw CannotAnswer(record.file + ": " + std::to_string(record.samples()) + " samples; a diagnosis needs at least 400");
  f.fourier = std::make_shared<Fourier>(f.samples);
  const double length_s = static_cast<double>(f.samples) * f.period_s;
  const double ramp_s = std::min(0.25, 0.05 * length_s);
  f.outer = make_ramp(f.samples, f.period_s, 0, ramp_s);
  f.inner = make_ramp(f.samples, f.period_s, ramp_s, ramp_s).weight;
  f.inner_energy = f.inner.squaredNorm();
  f.last_bin = static_cast<Eigen::Index>(top_of_band * static_cast<double>(f.samples));
  f.coarse = std::any_of(record.channels.begin(), record.channels.end(), coarse);
  bool absolute = true;  // every DOF has a displacement channel
  const int dofs = static_cast<int>(rig.dofs.size());
  for (int dof = 1; dof <= dofs; ++dof) {
    f.spectra.push_back(transform(record, dof, f));
    if (!f.spectra.back().any())
      throw CannotAnswer(record.file + ": no displacement, velocity or acceleration of DOF " + std::to_string(dof) +
                         "; measure one of them");
    absolute = absolute && f.spectra.back().measured[0];
    const host_sim::Channel* force = record.find(Quantity::kForce, dof);
    f.force.push_back(force ? Series(Series::Map(force->values.data(), static_cast<Eigen::Index>(f.samples))) : Series());
  }
  f.spectra.push_back(transform(record, rig_file::kBase, f));
  f.first_bin = absolute ? 0 : static_cast<Eigen::Index>(std::ceil(1.0 / f.bin_Hz()));
  return f;
}

}  // namespace diagnosis
