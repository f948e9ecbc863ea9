#include "host_sim/programs/shared/slow_drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/programs/shared/slow_part.hpp"
#include "host_sim/records/digitise.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace host_sim {
namespace {

constexpr double kMatters = 1.0;  // of the power of the integral: as large as the displacement itself
constexpr double kMostOfDrive = 0.25, kMostBesideMeasured = 0.35;  // the drive's lowest is told four bins too low
// Of the power of a displacement, that is measured: a tenth of its rms. The springs' share of it stands in the equations as a constant force
// does, while sensors are not better.
constexpr double kSlowDisplacement = 0.01;

// A channel of motion of which an integral is made: nothing lower is measured at its DOF.
bool is_integrated(const Record& record, const Channel& channel) {
  if (channel.quantity != Quantity::kVelocity && channel.quantity != Quantity::kAcceleration) return false;
  if (record.find(Quantity::kDisplacement, channel.dof) != nullptr) return false;
  return channel.quantity == Quantity::kVelocity || record.find(Quantity::kVelocity, channel.dof) == nullptr;
}

// How often a channel is integrated, and from what share of the motion on its drift matters there.
struct Tolerance {
  int integrations = 0;
  double least_share = 0.0;
};

// Nothing of a channel whose drift is nobody's loss.
std::optional<Tolerance> tolerance_of(DriftOf which, const Record& record, const Channel& channel) {
  if (is_drive(channel)) return Tolerance{};
  if (which == DriftOf::kDisplacements)
    return channel.quantity == Quantity::kDisplacement ? std::optional<Tolerance>({0, kSlowDisplacement})
                                                       : std::nullopt;
  if (!is_integrated(record, channel)) return std::nullopt;
  return Tolerance{channel.quantity == Quantity::kVelocity ? 1 : 2, kMatters};
}

// Below all that drives any record; 0: nothing does, or a drive reaches down to the record's length.
double lowest_drive_of(const std::vector<Record>& records) {
  double lowest_Hz = INFINITY;
  for (const Record& record : records)
    for (const Channel& channel : record.channels)
      if (is_drive(channel)) lowest_Hz = std::min(lowest_Hz, lowest_drive_Hz(channel.values, record.sample_period_s));
  return std::isfinite(lowest_Hz) ? lowest_Hz : 0.0;
}

// Is there anything to ask? Of what is integrated the core's plan tells whether it is.
bool concerns(DriftOf which, const rig_file::RigModel& model, const std::vector<Record>& records) {
  if (which == DriftOf::kDisplacements) return vocabulary::held_in_place(model);  // what no spring holds wanders
  const std::vector<Channel>& channels = records.front().channels;
  return std::any_of(channels.begin(), channels.end(),
                     [&](const Channel& c) { return is_integrated(records.front(), c); }) &&
         rig_file::integrates(rig_file::compile_rig(model, records.front().sample_period_s, calibrate(records, model)));
}

}  // namespace

Drift drift_of(DriftOf which, const rig_file::RigModel& model, const std::vector<Record>& records) {
  Drift drift;
  if (!concerns(which, model, records)) return {};
  drift.lowest_drive_Hz = lowest_drive_of(records);
  if (drift.lowest_drive_Hz == 0.0) return {};
  double of_drives_Hz = 0.0;
  for (const Record& record : records)
    for (const Channel& channel : record.channels) {
      const auto tolerance = tolerance_of(which, record, channel);
      if (!tolerance) continue;
      const double end_Hz = drift_end_Hz(channel.values, record.sample_period_s, drift.lowest_drive_Hz,
                                         tolerance->integrations, tolerance->least_share);
      double& end_of_kind_Hz = is_drive(channel) ? of_drives_Hz : drift.end_Hz;
      if (end_Hz > 0.0 && !is_drive(channel) && drift.channel.empty()) drift.channel = channel.name;
      end_of_kind_Hz = std::max(end_of_kind_Hz, end_Hz);
    }
  if (drift.end_Hz == 0.0) return {};
  drift.end_Hz = std::max(drift.end_Hz, of_drives_Hz);
  const double most = which == DriftOf::kDisplacements ? kMostBesideMeasured : kMostOfDrive;
  return drift.end_Hz > most * drift.lowest_drive_Hz ? Drift{} : drift;
}

void take_off(DriftOf which, const Drift& drift, std::vector<Record>& records) {
  for (Record& record : records)
    for (Channel& channel : record.channels) {
      take_off_cosines(channel.values, record.sample_period_s, drift.end_Hz);
      if (which == DriftOf::kIntegrated) continue;
      const double mean = std::accumulate(channel.values.begin(), channel.values.end(), 0.0) /
                          static_cast<double>(channel.values.size());
      for (double& value : channel.values) value -= mean;
    }
}

std::string said_of(const Drift& drift) {
  return fmt::format(
      "{} drifts, and nothing drives the rig below {:.3g} Hz: what is slower than {:.2g} Hz is taken off all channels",
      drift.channel, drift.lowest_drive_Hz, drift.end_Hz);
}

}  // namespace host_sim
