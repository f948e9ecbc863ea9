// Watches every sample and the passing of time for reasons to stop the drive. It decides only; SafeState
// (firmware/rig_controller) carries the decision out and latches it within the same step.
#pragma once
#include <cstdint>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/excitation/drive.hpp"
#include "firmware/supervision/alarm.hpp"

namespace firmware {

struct LimitConfiguration {
  uint16_t saturated_in_row =
      3;                     // samples at a rail, one after another on one channel, that stop the drive; at least 1
  uint16_t lost_in_row = 3;  // missing samples in one gap that stop the drive; at least 1
  uint32_t sample_timeout_us = 10000;                        // no sample for this long while driving: lost
  uint32_t step_timeout_us = 50000;                          // the controller not run for this long while driving: late
  int32_t response_limit_code[kMaxNodes][kQuantities] = {};  // |code - offset| above this stops the drive; 0: no limit
};

struct SupervisionCounters {
  uint32_t missed_samples = 0;
  uint32_t saturated_samples = 0;  // with any channel at a rail
};

class Supervisor {
 public:
  // Both must outlive this object.
  void configure(const CoreConfiguration& core, const LimitConfiguration& limits, const DriveLimits& drive);

  // The drive is live from now on: what was counted before does not count.
  void begin(uint64_t now_ns);

  // Each returns an alarm to report, kNone where all is well. One that stops the drive comes only where it is live; else
  // sensor and timing causes are counted (recordings, idle rigs). A sample is as old as its own time says; a time of 0,
  // or one that is still to come, is none.
  Alarm check_sample(const RawSample& sample, uint64_t now_ns, bool live);
  // The same in two parts, for a rig that is not live: whether samples are missing, and what its codes count, which nobody has
  // to ask where no channel is at a rail now (known_inside).
  Alarm check_arrival(const RawSample& sample, uint64_t now_ns) {
    last_sample_ns_ = has_time(sample, now_ns) ? sample.time_ns : now_ns;
    const uint32_t missed = sequence_known_ ? sample.sequence - sequence_ - 1 : 0;
    sequence_known_ = true;
    sequence_ = sample.sequence;
    return missed == 0 ? Alarm{} : judge_gap(missed, false);
  }
  void count_codes(const RawSample& sample, bool known_inside) {
    if (any_in_row_ || !known_inside) judge_codes(sample, false);
  }
  Alarm check_time(uint64_t now_ns, bool live) {
    const uint64_t last_ns = last_step_ns_;
    last_step_ns_ = now_ns;
    return live ? judge_time(now_ns - last_ns, now_ns - last_sample_ns_) : Alarm{};
  }
  Alarm check_drive(Drive command, bool live);
  Alarm source_ended(bool live) const;

  const SupervisionCounters& counters() const { return counters_; }

 private:
  static bool has_time(const RawSample& sample, uint64_t now_ns) {
    return sample.time_ns != 0 && sample.time_ns <= now_ns;
  }
  Alarm judge_codes(const RawSample& sample, bool live);
  Alarm judge_gap(uint32_t missed, bool live);
  Alarm judge_time(uint64_t since_step_ns, uint64_t since_sample_ns) const;
  bool all_inside(const RawSample& sample) const;

  const CoreConfiguration* core_ = nullptr;
  const LimitConfiguration* limits_ = nullptr;
  DriveLimits drive_;
  bool sequence_known_ = false;
  uint32_t sequence_ = 0;
  uint64_t last_sample_ns_ = 0;
  uint64_t last_step_ns_ = 0;
  // What a step looks at of a channel that is there.
  struct Channel {
    int32_t inside = 0;  // the lowest code that is not saturated
    uint32_t count = 0;  // of such codes
    int32_t offset = 0, limit = 0;
    uint16_t place = 0;  // among the sample's codes
    uint8_t node = 0, quantity = 0;
    uint16_t saturated_in_row = 0;
  };
  Alarm judge_code(Channel& channel, int32_t code, bool live);
  int channel_count_ = 0;
  bool alike_ = false;       // all channels have one range
  bool has_limits_ = false;  // of responses
  bool any_in_row_ = false;  // a channel was saturated in the sample before
  Channel channel_[kMaxNodes * kQuantities];
  Drive last_command_;
  SupervisionCounters counters_;
};

}  // namespace firmware
