#include "host_sim/plant/motion/base_signal.hpp"

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/instruments/smoothed.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

std::vector<double> integrated(const std::vector<double>& rate, double period_s) {
  std::vector<double> sum(rate.size(), 0.0);
  for (size_t k = 1; k < rate.size(); ++k) sum[k] = sum[k - 1] + 0.5 * period_s * (rate[k] + rate[k - 1]);
  return sum;
}

}  // namespace

SignalPtr base_signal(const Record& record, double start_s, Interpolation interpolation) {
  const double period_s = record.sample_period_s;
  if (const Channel* x = record.find(Quantity::kDisplacement, rig_file::kBase))
    return sampled(smoothed(x->values), start_s, period_s, interpolation);
  if (const Channel* v = record.find(Quantity::kVelocity, rig_file::kBase))
    return sampled(integrated(smoothed(v->values), period_s), start_s, period_s, interpolation);
  throw PlantError(
      "the rig has a link to the base, but the record has no channel displacement_base_m or velocity_base_m_s");
}

}  // namespace host_sim
