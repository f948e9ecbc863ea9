// From a record to spectra.
#include <algorithm>
#include <cmath>

#include "motion.hpp"

namespace diagnosis {
namespace {

// What is integrated drifts below it; of the sampling rate, at most: the motion of a tower or a ship is not all drift.
constexpr double kDrifts_Hz = 1, kDriftsOfRate = 0.01;
constexpr double kRamp = 0.25, kRampOfRecord = 0.05;  // of the period of that, and of the record

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
    throw CannotAnswer(record.file + ": " + std::to_string(record.samples()) +
                       " samples; a diagnosis needs at least 400");
  f.fourier = std::make_shared<Fourier>(f.samples);
  const double length_s = static_cast<double>(f.samples) * f.period_s;
  f.slow_Hz = std::min(kDrifts_Hz, kDriftsOfRate / f.period_s);
  const double ramp_s = std::min(kRamp / f.slow_Hz, kRampOfRecord * length_s);
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
    const host_sim::Channel* force = record.find(host_sim::Quantity::kForce, dof);
    f.force.push_back(force ? Series(Series::Map(force->values.data(), static_cast<Eigen::Index>(f.samples)))
                            : Series());
  }
  f.spectra.push_back(transform(record, rig_file::kBase, f));
  f.first_bin = absolute ? 0 : f.first_beyond(f.slow_Hz);
  return f;
}

}  // namespace diagnosis
