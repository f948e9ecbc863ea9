// Sensors judged before any rig model: what of a DOF's displacement, velocity and acceleration is not one motion seen
// three times is the fault of a channel.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "../record/motion.hpp"

namespace diagnosis {

enum class FaultKind { kDelay, kGain, kAcCoupling, kHum50, kHum60 };
inline bool is_hum(FaultKind kind) { return kind == FaultKind::kHum50 || kind == FaultKind::kHum60; }
inline double hum_Hz(FaultKind kind) { return kind == FaultKind::kHum50 ? 50 : 60; }

// Standard deviations at which chi-squared passes a threshold in 95 of 100 records.
inline double seen_in_95_of_100(double threshold) { return std::sqrt(threshold) + 1.645; }

struct SensorFault {
  FaultKind kind = FaultKind::kDelay;
  size_t dof = 0;       // index into FusedRecord::spectra
  size_t quantity = 0;  // displacement, velocity, acceleration
  std::string channel;
  double value = 0;       // delay s; gain error 1; corner Hz; hum: amplitude of the cosine, channel's unit
  double quadrature = 0;  // hum: amplitude of the sine
  double std = 0;
  double score = 0;  // gain of chi-squared over the noise that remains
};

inline bool same_fault(const SensorFault& a, const SensorFault& b) {
  return a.kind == b.kind && a.dof == b.dof && a.quantity == b.quantity;
}

struct SensorCheck {
  std::vector<SensorFault> faults;
  std::vector<std::vector<SensorFault>> rivals;  // per fault: others that explain it as well
  // Every fault of every channel of the DOFs: `value` the smallest that would be named in 95 of 100 such records, infinity
  // where a DOF has no second channel that could tell.
  std::vector<SensorFault> smallest;
};

// What the strongest fault of a DOF's channels would explain (fall of chi-squared over the noise that remains).
double strongest_fault(const FusedRecord& record, size_t dof);

// Takes a fault out of a record's spectra; the noise is to be estimated and the motion fused anew.
void correct_fault(FusedRecord& record, const SensorFault& fault);
// Adds a further step of the same fault: a delay or a gain is found in steps.
void accumulate(SensorFault& total, const SensorFault& step);

// Finds faults, corrects the record's spectra for them and leaves its noise, which it wants estimated, estimated anew.
SensorCheck check_sensors(FusedRecord& record);

}  // namespace diagnosis
