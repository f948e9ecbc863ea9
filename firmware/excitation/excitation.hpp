// Runs an excitation programme, one drive command per sample: ramp, settle, measure, next; at the end down to zero.
//
//   idle -> ramping -> settling -> measuring -> ramping (next level) ... -> ramping (to zero) -> done
//
// Between two sines of the same frequency the envelope glides from one amplitude to the next with the phase running on;
// otherwise it goes down to zero first. No ramp takes longer than ramp_samples, wherever it starts (to the sample where that many fit
// into the envelope's steps). A free decay is released at once: its drive is zero from the first measured
// sample.
#pragma once
#include <cstdint>

#include "firmware/excitation/band_noise.hpp"
#include "firmware/excitation/programme.hpp"

namespace firmware {

enum class ExcitationState : uint8_t { kIdle, kRamping, kSettling, kMeasuring, kDone };

enum class ExcitationEvent : uint8_t {
  kNone,
  kMeasureBegins,  // the next sample is the first of the level's measurement
  kMeasureEnds,    // this sample was the last of it
  kLevelSkipped,   // the response did not settle in time and the level is left out
  kFinished,       // the drive has come down to zero
};

class Excitation {
 public:
  // The programme must outlive this object and have passed check().
  // extra_samples: every measurement is that much longer, for filters that need samples beyond their window.
  void configure(const ExcitationProgramme& programme, int dof_count, uint32_t extra_samples = 0);
  void start();
  void stop();   // ramps to zero from wherever it is, then done
  void abort();  // drive zero at once, state idle
  // One sample has been taken: response_code holds one code per DOF, offset removed. Returns what happened with it.
  ExcitationEvent step(const int32_t* response_code);

  Drive drive() const { return drive_; }  // the command for the time until the next sample
  ExcitationState state() const { return state_; }
  uint8_t level() const { return level_; }
  bool unsettled() const { return unsettled_; }  // the level being measured did not settle within its limit

 private:
  const ExcitationLevel& current() const { return programme_->levels[level_]; }
  void begin_ramp(bool to_zero);
  void enter_level(uint8_t level);
  ExcitationEvent ramp();
  ExcitationEvent settle(const int32_t* response_code);
  ExcitationEvent begin_measuring();
  ExcitationEvent measure();
  void leave_level();
  int64_t signal();
  void command();

  const ExcitationProgramme* programme_ = nullptr;
  int dof_count_ = 0;
  uint32_t extra_samples_ = 0;
  ExcitationState state_ = ExcitationState::kIdle;
  uint8_t level_ = 0;
  bool stopping_ = false;  // the ramp goes to zero
  bool last_ = false;      // no level follows, whatever the programme holds
  bool unsettled_ = false;
  uint32_t phase_ = 0;
  int32_t envelope_ = 0;  // Q0.31
  int32_t rise_ = 1;      // Q0.31, of a ramp in a sample
  uint32_t samples_ = 0;  // in the present state
  Drive drive_;
  BandNoise noise_;
  SettleDetector settle_;
};

}  // namespace firmware
