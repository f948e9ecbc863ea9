// The course of a step: stop line, samples, excitation, safe state. See rig_controller.hpp.
#include "firmware/rig_controller/rig_controller.hpp"

#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {

RigController::RigController(const ControllerConfiguration& configuration, const Ports& ports)
    : ports_(ports),
      listening_(configuration.programme.level_count == 0),
      drive_(ports.drive, queue_),
      safe_(ports.emergency_stop, ports.relay, drive_),
      lamp_(ports.ready_lamp),
      windows_(configuration_, queue_),
      descriptions_(configuration_, queue_),
      configuration_(configuration),
      objects_(configuration_, schedule_, safe_, bus_, ports.store, ports.store_worker),
      sdo_(objects_),
      measurement_(configuration_, ports.worker) {
  excitation_.configure(configuration_.programme, configuration_.core.dof_count,
                        static_cast<uint32_t>(core().margin_samples()));
  supervisor_.configure(configuration_.core, configuration_.limits, configuration_.programme.limits);
  drive_.configure(configuration_.node.node, configuration_.node.drive_on_can,
                   configuration_.programme.limits.step_per_sample);
}

void RigController::step() {
  now_ns_ = ports_.clock.now_ns();
  safe_.begin_step(now_ns_);
  objects_.begin_step(now_ns_);
  measurement_.begin_step(now_ns_);
  if (!booted_) boot();
  handle(safe_.look_at_line());
  judge(supervisor_.check_time(now_ns_, safe_.live()));
  const hal::CanResult received = ports_.can.receive(frame_);
  if (received != hal::CanResult::kEmpty) receive_frames(received);
  if (objects_.has_news()) check_save();
  if (measurement_.waits()) go_on_measuring();
  if (measurement_.has_result()) take_results();
  const bool all_taken = take_samples();
  if (ports_.sync_edge != nullptr) check_sync_edge();
  if (safe_.state() == SafeState::State::kStopping) safe_.make_safe();
  if (start_waits_ && all_taken && safe_.may_start()) start();
  if (!schedule_.quiet(now_ns_)) run_schedule();
  const bool alarms = alarms_.waiting() != 0 || queue_.given_up() != reported_drops_;
  if (alarms || windows_.floats_wait() || descriptions_.wait()) send_waiting();
  if (queue_.waiting() != 0 || !bus_.may_send()) flush_queue();
  if (safe_.awaits_delivery()) handle(safe_.check_delivery());
  lamp_.show(!safe_.tripped());
  if (!safe_.output_refuses() && !measurement_.worker_late()) ports_.watchdog.feed();
}

void RigController::go_on_measuring() {
  measurement_.go_on();
  const Alarm worker = measurement_.worker_alarm();
  safe_.live() ? judge(worker) : handle(worker);
  handle(measurement_.loss_alarm());
}

void RigController::boot() {
  booted_ = true;
  boot_ns_ = now_ns_;
  queue_.push(pack_heartbeat(configuration_.node.node, HeartbeatState::kBootUp), false);
  flush_queue();
  handle(safe_.check_delivery());
  safe_.make_safe();
  flush_queue();
  handle(safe_.check_delivery());
  handle(objects_.load());
  uint8_t level = 0;
  const ProgrammeFault fault = check(configuration_.programme, level);
  if (fault != ProgrammeFault::kNone) {
    judge({AlarmCause::kConfiguration, static_cast<uint32_t>(fault) << 8 | level});
  }
  if (!core().fits() || (configuration_.node.can_fd && !kSendsFd))
    judge({AlarmCause::kConfiguration, static_cast<uint32_t>(ProgrammeFault::kCapacity) << 8});
  objects_.apply();
  schedule_.start(now_ns_);
  start_waits_ = configuration_.programme.start_at_boot && starts_by_itself_ && !safe_.tripped();
}

bool RigController::start() {
  if (!booted_) return false;
  handle(safe_.look_at_line());  // the press may be newer than the step's look
  start_waits_ = false;
  if (!safe_.may_start()) return false;
  if (listening_) return start_listening();
  const ExcitationState state = excitation_.state();
  if (state != ExcitationState::kIdle && state != ExcitationState::kDone) return false;
  forget_estimates();
  finished_ = false;
  handle(safe_.energise());
  if (!safe_.live()) return false;
  supervisor_.begin(now_ns_);
  excitation_.start();
  return true;
}

bool RigController::start_listening() {
  if (measurement_.running()) return false;
  if (configuration_.node.listen_on_command) {
    if (!measurement_.has_room()) return false;
    measurement_.begin_level();
    return true;
  }
  if (!finished_) return false;
  forget_estimates();
  finished_ = false;
  return true;
}

void RigController::forget_estimates() {
  measurement_.forget();
  windows_.forget();
}

void RigController::stop() {
  start_waits_ = false;
  end_level();
  excitation_.stop();
  finished_ = finished_ || (listening_ && !configuration_.node.listen_on_command);
}

bool RigController::reset() {
  if (!booted_) return false;
  handle(safe_.look_at_line());
  if (safe_.latched().cause == AlarmCause::kConfiguration) return false;
  const bool was_tripped = safe_.tripped();
  if (!safe_.reset()) return false;
  if (!was_tripped) {
    if (listening_ && !measurement_.running()) forget_estimates();
    return true;
  }
  alarms_.push(emergency_of(Alarm{}, objects_.error_register()), false);
  send_status();
  return true;
}

// Whatever comes is measured, or what comes between two commands; nothing where the rig has no room in the core.
bool RigController::begins_level() const {
  return listening_ && !finished_ && !configuration_.node.listen_on_command && core().fits();
}

[[gnu::noinline]] void RigController::drive_on(const RawSample& sample) {
  int32_t codes[kMaxDofs];
  response_codes(sample, codes);
  const ExcitationEvent event = excitation_.step(codes);
  command_drive(excitation_.drive(), sample.sequence);
  if (safe_.live()) follow(event);
}

inline void RigController::take_sample(const RawSample& sample) {
  const bool live = safe_.live();
  judge(live ? supervisor_.check_sample(sample, now_ns_, true) : supervisor_.check_arrival(sample, now_ns_));
  if (!measurement_.running() && begins_level()) measurement_.begin_level();
  const bool inside = measurement_.take(sample);
  if (!live) supervisor_.count_codes(sample, inside);
  if (safe_.live()) drive_on(sample);
  measurement_.close_full_window();
  if (measurement_.has_result()) take_results();
}

// False where samples are left: those that waited while the program started are too old to drive by.
bool RigController::take_samples() {
  for (int taken = 0; taken < kSamplesPerStep; ++taken) {
    const hal::SampleResult result = ports_.samples.read(sample_);
    if (result == hal::SampleResult::kSample) {
      source_stopped_ = false;
      take_sample(sample_);
      continue;
    }
    if (result != hal::SampleResult::kNone) source_stopped(result == hal::SampleResult::kFault);
    return true;
  }
  return false;
}

// Displacement where there is one, else velocity, else acceleration.
void RigController::response_codes(const RawSample& sample, int32_t (&codes)[kMaxDofs]) const {
  constexpr Quantity kPreferred[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};
  for (int dof = 0; dof < configuration_.core.dof_count; ++dof) {
    codes[dof] = 0;
    for (Quantity quantity : kPreferred) {
      const int q = static_cast<int>(quantity);
      const ChannelConfiguration& channel = configuration_.core.channels[dof][q];
      if (!channel.present) continue;
      codes[dof] = clamp_magnitude(static_cast<int64_t>(sample.code[dof][q]) - channel.offset_code, INT32_MAX);
      break;
    }
  }
}

// When listening a read that fails leaves a gap; a source that goes on failing is gone, like one that has ended.
void RigController::source_stopped(bool fault) {
  if (!source_stopped_) {
    source_stopped_ = true;
    source_gone_ = false;
    stopped_ns_ = now_ns_;
    judge(supervisor_.source_ended(safe_.live()));
    if (fault && !safe_.tripped()) handle({AlarmCause::kSensorFault});
  }
  if (!listening_ || source_gone_ || (fault && now_ns_ - stopped_ns_ < kSourceGone_ns)) return;
  source_gone_ = true;
  end_level();
  finished_ = true;
}

void RigController::follow(ExcitationEvent event) {
  switch (event) {
    case ExcitationEvent::kNone:
      break;
    case ExcitationEvent::kMeasureBegins:
      if (excitation_.unsettled()) handle({AlarmCause::kNotSettled, excitation_.level()});
      measurement_.begin_level();
      break;
    case ExcitationEvent::kMeasureEnds:
      end_level();
      break;
    case ExcitationEvent::kLevelSkipped:
      handle({AlarmCause::kNotSettled, excitation_.level()});
      break;
    case ExcitationEvent::kFinished:
      handle(safe_.end());
      finished_ = true;
      break;
  }
}

void RigController::end_level() {
  measurement_.end_level();
  take_results();
}

void RigController::command_drive(Drive wanted, uint32_t sequence) {
  const Drive drive = drive_.reachable(wanted);
  judge(supervisor_.check_drive(drive, safe_.live()));
  handle(safe_.command(drive, sequence));
}

// What stops the rig is carried out at once.
void RigController::stop_or_tell(const Alarm& alarm) { tell(stops_drive(alarm.cause) ? safe_.stop(alarm) : alarm); }

void RigController::tell(const Alarm& alarm) {
  if (!alarm) return;
  passing_faults_ = static_cast<uint16_t>(passing_faults_ | status_bit(alarm.cause));
  const bool stopped = stops_drive(alarm.cause) && safe_.tripped();
  if (stopped) {
    start_waits_ = false;  // a reset clears the reason, it moves nothing
    excitation_.abort();
    if (!listening_) measurement_.cut_level();
  }
  alarms_.push(emergency_of(alarm, objects_.error_register()), stopped);
  if (stopped) send_status();
}

ControllerMode RigController::mode() const {
  if (!booted_) return ControllerMode::kInitialising;
  if (safe_.latched().cause == AlarmCause::kEmergencyStop) return ControllerMode::kEmergencyStop;
  if (safe_.tripped()) return ControllerMode::kFault;
  if (listening_)
    return measurement_.running() ? ControllerMode::kIntegrate
           : finished_            ? ControllerMode::kDone
                                  : ControllerMode::kIdle;
  switch (excitation_.state()) {
    case ExcitationState::kIdle:
      return ControllerMode::kIdle;
    case ExcitationState::kRamping:
      return ControllerMode::kRamp;
    case ExcitationState::kSettling:
      return ControllerMode::kSettle;
    case ExcitationState::kDone:
      return ControllerMode::kDone;
    case ExcitationState::kMeasuring:
      break;
  }
  const ExcitationLevel& level = configuration_.programme.levels[excitation_.level()];
  return level.kind == ExcitationKind::kFreeDecay ? ControllerMode::kFreeDecay : ControllerMode::kIntegrate;
}

}  // namespace firmware
