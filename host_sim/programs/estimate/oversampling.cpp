#include "host_sim/programs/estimate/oversampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/recorded/moving_samples.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/data_check/measures/spectrum.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/thin_out.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace host_sim {
namespace {

constexpr double kAboveNoise = 4.0;
// Samples that a period of the fastest motion keeps. The low-pass of derivatives reaches to a tenth of the sample rate, or to a fifth where
// motion goes up there. Noise of a second slope grows with the corner to the power of 5/2, and what it does to friction's sign with
// that: an eighth is better for every kind of motion but sticking, whose rests a lower rate smears.
constexpr double kRatesOfSlope = 10.0, kRatesOfSecondSlope = 8.0;
// Where no mass smooths what friction does, the force jumps at every reversal, and a jump that a low-pass rounds over a tenth of a period
// is taken for another law: a tenth of a swing.
constexpr double kRatesOfJumps = 20.0;
constexpr size_t kFewestThinned = 8 * firmware::kBlockSamples;
constexpr size_t kLongestStretch = 2048, kShortestStretch = 256;

// Power of the differences, mean over stretches that overlap by half: a drift of the values leaks into no other bin of theirs.
std::vector<double> power_of_differences(const std::vector<double>& values) {
  std::vector<double> step(values.size() - 1);
  for (size_t i = 0; i < step.size(); ++i) step[i] = values[i + 1] - values[i];
  const size_t wanted = std::clamp(step.size() / 4, kShortestStretch, kLongestStretch);
  const size_t length = data_check::quick_length(std::min(step.size(), wanted));
  std::vector<double> sum;
  for (size_t from = 0; from + length <= step.size(); from += length / 2) {
    const double mean =
        std::accumulate(step.begin() + static_cast<long>(from), step.begin() + static_cast<long>(from + length), 0.0) /
        static_cast<double>(length);
    const std::vector<double> power = data_check::power_spectrum(step.data() + from, length, mean);
    sum.resize(power.size(), 0.0);
    for (size_t k = 0; k < power.size(); ++k) sum[k] += power[k];
  }
  return sum;
}

// What the low-pass of the derivatives takes at a record's start may be as long as the bulk of its motion, no longer: friction ends it soon.
size_t most_of_motion(const std::vector<Record>& records) {
  constexpr double kReach = 2 * firmware::kFilterHalf + 1;
  double most = 1e9;
  for (const Record& record : records)
    for (const Channel& channel : record.channels) {
      if (channel.quantity == Quantity::kForce) continue;
      const double moving = rig_file::moving_samples(channel.values);
      if (moving > 0.0) most = std::min(most, moving / kReach);
    }
  return std::max<size_t>(1, static_cast<size_t>(most));
}

bool reaches_its_end(const std::vector<Record>& records,
                     const std::vector<rig_file::ChannelCalibration>& calibrations) {
  for (const Record& record : records)
    for (const rig_file::ChannelCalibration& calibration : calibrations)
      if (const Channel* const channel = record.find(static_cast<Quantity>(calibration.quantity), calibration.dof))
        for (const double value : channel->values) {
          const int32_t code = to_code(value, calibration);
          if (code <= calibration.lowest_code || code >= calibration.highest_code) return true;
        }
  return false;
}

double samples_a_period(const rig_file::RigModel& model, const firmware::CoreConfiguration& planned) {
  if (vocabulary::massless(model)) return kRatesOfJumps;
  return rig_file::differentiates_twice(planned) ? kRatesOfSecondSlope : kRatesOfSlope;
}

}  // namespace

double highest_motion_Hz(const std::vector<double>& values, double sample_period_s) {
  if (values.size() <= kShortestStretch) return 0.5 / sample_period_s;
  std::vector<double> power = power_of_differences(values);
  const size_t bins = power.size();
  for (size_t k = 1; k < bins; ++k) {
    const double slope = 2.0 * std::sin(0.5 * M_PI * static_cast<double>(k) / static_cast<double>(bins - 1));
    power[k] /= slope * slope;
  }
  const double noise = data_check::median_power(power, 3 * bins / 4, bins);
  size_t k = bins - 2;
  while (k > 1 && power[k - 1] + power[k] + power[k + 1] <= 3.0 * kAboveNoise * noise) --k;
  return static_cast<double>(k + 1) * 0.5 / (static_cast<double>(bins - 1) * sample_period_s);
}

Oversampling oversampling_of(const rig_file::RigModel& model, const std::vector<Record>& records) {
  Oversampling result;
  const std::vector<rig_file::ChannelCalibration> calibrations = calibrate(records, model);
  const double period_s = records.front().sample_period_s;
  const firmware::CoreConfiguration planned = rig_file::compile_rig(model, period_s, calibrations);
  if (!rig_file::differentiates(planned)) return result;
  size_t shortest = records.front().samples();
  for (const Record& record : records) {
    shortest = std::min(shortest, record.samples());
    for (const Channel& channel : record.channels)
      if (channel.quantity != Quantity::kForce)
        result.motion_Hz = std::max(result.motion_Hz, highest_motion_Hz(channel.values, record.sample_period_s));
  }
  const double most = 1.0 / (samples_a_period(model, planned) * result.motion_Hz * period_s);
  size_t factor = most < 2.0 ? 1 : static_cast<size_t>(std::min(most, static_cast<double>(shortest)));
  factor = std::min(factor, most_of_motion(records));
  while (factor > 1 && thinned_samples(shortest, factor) < kFewestThinned) --factor;
  if (factor > 1 && !reaches_its_end(records, calibrations)) result.factor = factor;
  return result;
}

std::string take_fewer_samples(rig_file::RigModel& model, SharedRecords& records) {
  const Oversampling oversampling = oversampling_of(model, records.get());
  if (oversampling.factor == 1) return {};
  for (Record& record : records.own()) record = thinned(record, oversampling.factor);
  for (rig_file::ChannelEntry& entry : model.channels) entry.unit_per_code = 0.0;
  return fmt::format(
      "the motion ends at {:.3g} Hz: of {} samples one is taken, behind one low-pass for all channels ({:.4g} Hz), "
      "because slopes "
      "have the noise of all that lies above it",
      oversampling.motion_Hz, oversampling.factor, 1.0 / records.get().front().sample_period_s);
}

}  // namespace host_sim
