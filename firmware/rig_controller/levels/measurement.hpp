// Levels and windows: which samples go to the estimator, and when their estimates are asked for.
//
// Windows are counted in samples, so that the same samples give the same frames on every machine. The warrant of the
// estimates is told once a second and at the end of each level.
#pragma once
#include "firmware/rig_controller/levels/estimation.hpp"
#include "firmware/rig_controller/levels/sample_clock.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "firmware/supervision/alarm.hpp"

namespace firmware {

class Measurement {
 public:
  // worker: nullptr where there is none. Both must outlive this.
  Measurement(const ControllerConfiguration& configuration, hal::Worker* worker)
      : configuration_(configuration), estimation_(configuration.core, worker) {}

  void begin_step(uint64_t now_ns) { estimation_.begin_step(now_ns); }  // first thing in a step
  // Something waits for the worker or has not been told; then, once in a step:
  bool waits() const { return !estimation_.idle() || estimation_.dropped_samples() != told_dropped_; }
  void go_on() { estimation_.go_on(); }
  // What go_on() found out; kNone where there is nothing to tell.
  Alarm worker_alarm();  // the worker does not come back; once
  Alarm loss_alarm();    // samples that found no room

  void forget() {  // everything that was measured
    levels_ = 0;
    estimation_.reset();
  }
  bool has_room();  // for one more level
  void begin_level();
  void end_level();  // and its window
  void cut_level();  // the same, without estimates: the rig was stopped
  // Where a level is measured. True: the core has it and found no channel at a rail.
  bool take(const RawSample& sample) {
    if (!running_) return false;
    if (samples_in_window_++ % kClockEvery == 0) clock_.take(sample);
    return estimation_.push(sample);
  }
  void close_window();        // now
  void close_full_window() {  // where it has its samples
    if (running_ && samples_in_window_ >= window_samples_) close_window();
  }
  void close_begun_window();  // where it has any

  bool has_result() const { return estimation_.has_result(); }
  bool take_result() { return estimation_.take_result(); }  // true: results() are new
  const Estimation::Results& results() const { return estimation_.results(); }
  bool running() const { return running_; }
  bool idle() const { return estimation_.idle(); }  // all estimates are out
  bool worker_late() const { return worker_late_; }
  const Estimation& estimation() const { return estimation_; }

 private:
  const ControllerConfiguration& configuration_;
  bool running_ = false;  // samples go to the core
  bool worker_late_ = false;
  uint32_t samples_in_window_ = 0, window_samples_ = 0;  // so far, and of a full one
  int levels_ = 0;  // asked for since forget(); fewer where the core has forgotten some since
  uint32_t told_dropped_ = 0;
  uint64_t next_judgement_ns_ = 0;
  static constexpr uint32_t kClockEvery = 64;  // samples: a look at the time costs as much as the rest of take()
  SampleClock clock_;
  Estimation estimation_;
};

}  // namespace firmware
