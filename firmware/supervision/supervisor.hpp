// Watches every sample and the passing of time, and latches the first reason to stop the drive (an
// emergency stop takes precedence over others).
// It decides only; RigController carries the decision out (drive zero, relay off) within the same step.
#pragma once
#include <cstdint>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/excitation/drive.hpp"
#include "firmware/supervision/alarm.hpp"

namespace firmware {

struct LimitConfiguration {
  uint16_t saturated_in_row =
      3;                     // samples at full scale, one after another on one channel, that stop the drive; at least 1
  uint16_t lost_in_row = 3;  // missing samples in one gap that stop the drive; at least 1
  uint32_t sample_timeout_us = 10000;                        // no sample for this long while driving: lost
  uint32_t step_timeout_us = 50000;                          // the controller not run for this long while driving: late
  int32_t response_limit_code[kMaxNodes][kQuantities] = {};  // |code - offset| above this stops the drive; 0: no limit
};

struct SupervisionCounters {
  uint32_t missed_samples = 0;
  uint32_t saturated_samples = 0;
  uint32_t trips = 0;
};

class Supervisor {
 public:
  // Both must outlive this object.
  void configure(const CoreConfiguration& core, const LimitConfiguration& limits, const DriveLimits& drive);

  // While armed the drive is live: sensor and timing causes stop it. Unarmed they are only counted (recordings, idle
  // rigs).
  void arm(uint64_t now_ns);
  void disarm() { armed_ = false; }
  bool armed() const { return armed_; }

  // Each returns an alarm to report (cause kNone where all is well); a stopping one is latched already.
  Alarm check_sample(const RawSample& sample, uint64_t now_ns);
  Alarm check_time(uint64_t now_ns);
  Alarm check_drive(Drive command);
  Alarm source_ended();
  Alarm trip(Alarm alarm);  // from outside: emergency stop, outputs that fail

  bool tripped() const { return static_cast<bool>(latched_); }
  const Alarm& latched() const { return latched_; }
  void reset() { latched_ = Alarm{}; }

  const SupervisionCounters& counters() const { return counters_; }

 private:
  Alarm check_sequence(const RawSample& sample);
  Alarm check_channel(const RawSample& sample, int node, int quantity);
  Alarm stop_if_armed(Alarm alarm);

  const CoreConfiguration* core_ = nullptr;
  const LimitConfiguration* limits_ = nullptr;
  DriveLimits drive_;
  bool armed_ = false;
  bool sequence_known_ = false;
  uint32_t sequence_ = 0;
  uint64_t last_sample_ns_ = 0;
  uint64_t last_step_ns_ = 0;
  uint16_t saturated_in_row_[kMaxNodes][kQuantities] = {};
  Drive last_command_;
  Alarm latched_;
  SupervisionCounters counters_;
};

}  // namespace firmware
