// The course of a step: stop line, samples, excitation, safe state. See rig_controller.hpp.
#include "firmware/rig_controller/rig_controller.hpp"

#include "firmware/can_protocol/packing.hpp"

namespace firmware {

RigController::RigController(const ControllerConfiguration& configuration, const Ports& ports)
    : configuration_(configuration),
      default_node_(configuration.node),
      ports_(ports),
      emergency_line_(ports.emergency_stop),
      estimation_(configuration_.core, ports.worker),
      sdo_(*this) {
  excitation_.configure(configuration_.programme, configuration_.core.dof_count,
                        static_cast<uint32_t>(core().margin_samples()));
  supervisor_.configure(configuration_.core, configuration_.limits, configuration_.programme.limits);
  listening_ = configuration_.programme.level_count == 0;
}

void RigController::step() {
  now_ns_ = ports_.clock.now_ns();
  pressed_in_step_ = false;
  if (!booted_) boot();
  check_emergency_stop();
  handle(supervisor_.check_time(now_ns_));
  receive_frames();
  check_save();
  estimation_.advance();
  take_results();
  take_samples();
  check_sync_edge();
  if (safe_pending_) make_safe();
  run_schedule();
  flush_queue();
  set_ready_lamp();
  if (!safe_pending_) ports_.watchdog.feed();
}

void RigController::boot() {
  booted_ = true;
  boot_ns_ = now_ns_;
  queue_.push(pack_heartbeat(configuration_.node.node, HeartbeatState::kBootUp), false);
  flush_queue();
  make_safe();
  flush_queue();
  load_from_store();
  configuration_crc_ = firmware::configuration_crc(configuration_);
  uint8_t level = 0;
  const ProgrammeFault fault = check(configuration_.programme, level);
  if (fault != ProgrammeFault::kNone) {
    handle(supervisor_.trip({AlarmCause::kConfiguration, static_cast<uint32_t>(fault) << 8 | level}));
  }
  apply_node_settings();
  second_.start(now_ns_, 1000000000);
  five_seconds_.start(now_ns_, 5000000000);
  if (configuration_.programme.start_at_boot) start();
}

// True where the line has been pressed in this step, so that a command which was sent before the press does nothing.
// Whoever looks at the line acts on what it sees: a look cannot swallow a press.
bool RigController::check_emergency_stop() {
  const bool pressed = emergency_line_.pressed();
  const bool told = supervisor_.latched().cause == AlarmCause::kEmergencyStop;
  pressed_in_step_ = pressed_in_step_ || pressed;
  if (pressed && !told) handle(supervisor_.trip({AlarmCause::kEmergencyStop}));
  return pressed_in_step_;
}

bool RigController::start() {
  if (!booted_ || check_emergency_stop() || supervisor_.tripped() || safe_pending_) return false;
  if (listening_) return start_listening();
  const ExcitationState state = excitation_.state();
  if (state != ExcitationState::kIdle && state != ExcitationState::kDone) return false;
  forget_estimates();
  finished_ = false;
  set_relay(true);
  if (supervisor_.tripped()) return false;
  supervisor_.arm(now_ns_);
  excitation_.start();
  return true;
}

bool RigController::start_listening() {
  if (measuring_) return false;
  if (configuration_.node.listen_on_command) {
    begin_measurement();
    return true;
  }
  if (!finished_) return false;
  forget_estimates();
  finished_ = false;
  return true;
}

void RigController::forget_estimates() {
  estimation_.reset();
  estimates_ = nullptr;
  judged_ = false;
}

void RigController::stop() {
  end_measurement();
  excitation_.stop();
  finished_ = finished_ || (listening_ && !configuration_.node.listen_on_command);
}

bool RigController::reset() {
  if (!booted_ || check_emergency_stop() || safe_pending_) return false;
  if (supervisor_.latched().cause == AlarmCause::kConfiguration) return false;
  if (!supervisor_.tripped()) {
    if (listening_ && !measuring_) forget_estimates();
    return true;
  }
  supervisor_.reset();
  alarms_.push(emergency_of(Alarm{}, error_register()), false);
  send_status();
  return true;
}

void RigController::take_samples() {
  RawSample sample;
  for (int taken = 0; taken < kSamplesPerStep; ++taken) {
    switch (ports_.samples.read(sample)) {
      case hal::SampleResult::kSample:
        source_stopped_ = false;
        take_sample(sample);
        break;
      case hal::SampleResult::kNone:
        return;
      case hal::SampleResult::kEnd:
        return source_stopped(false);
      case hal::SampleResult::kFault:
        return source_stopped(true);
    }
  }
}

void RigController::take_sample(const RawSample& sample) {
  handle(supervisor_.check_sample(sample, now_ns_));
  if (listening_ && !measuring_ && !finished_ && !configuration_.node.listen_on_command) begin_measurement();
  if (measuring_) {
    estimation_.push(sample);
    ++samples_in_window_;
  }
  if (supervisor_.armed()) {
    int32_t codes[kMaxDofs];
    response_codes(sample, codes);
    const ExcitationEvent event = excitation_.step(codes);
    command_drive(excitation_.drive(), sample.sequence);
    follow(event);
  }
  if (measuring_ && samples_in_window_ >= configuration_.node.window_samples) close_window();
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

void RigController::source_stopped(bool fault) {
  if (source_stopped_) return;
  source_stopped_ = true;
  handle(supervisor_.source_ended());
  if (fault && !supervisor_.tripped()) handle({AlarmCause::kSensorFault});
  if (!listening_) return;
  end_measurement();
  finished_ = true;
}

void RigController::follow(ExcitationEvent event) {
  switch (event) {
    case ExcitationEvent::kNone:
      break;
    case ExcitationEvent::kMeasureBegins:
      if (excitation_.unsettled()) handle({AlarmCause::kNotSettled, excitation_.level()});
      begin_measurement();
      break;
    case ExcitationEvent::kMeasureEnds:
      end_measurement();
      break;
    case ExcitationEvent::kLevelSkipped:
      handle({AlarmCause::kNotSettled, excitation_.level()});
      break;
    case ExcitationEvent::kFinished:
      supervisor_.disarm();
      set_relay(false);
      finished_ = true;
      break;
  }
}

void RigController::begin_measurement() {
  estimation_.begin_level();
  measuring_ = true;
  samples_in_window_ = 0;
}

void RigController::end_measurement() {
  if (!measuring_) return;
  estimation_.end_level();
  measuring_ = false;
  close_window();
}

void RigController::command_drive(Drive drive, uint32_t sequence) {
  handle(supervisor_.check_drive(drive));
  if (supervisor_.tripped()) return;
  if (!ports_.drive.write(drive.raw)) return handle(supervisor_.trip({AlarmCause::kDriveNotTaken}));
  if (!configuration_.node.drive_on_can) return;
  queue_.push(pack_drive(configuration_.node.node, {drive.raw, sequence, DriveState::kEnabled}));
}

void RigController::handle(const Alarm& alarm) {
  if (!alarm) return;
  passing_faults_ = static_cast<uint16_t>(passing_faults_ | status_bit(alarm.cause));
  const bool stopping = stops_drive(alarm.cause) && supervisor_.tripped();
  if (stopping) make_safe();
  alarms_.push(emergency_of(alarm, error_register()), stopping);
  if (stopping) send_status();
}

// Drive zero and relay off, now; tried again in every step until both are delivered.
void RigController::make_safe() {
  excitation_.abort();
  supervisor_.disarm();
  const bool drive_dead = ports_.drive.write(0);
  const bool relay_open = ports_.relay.set(false);
  relay_on_ = relay_on_ && !relay_open;
  safe_pending_ = !drive_dead || !relay_open;
  if (configuration_.node.drive_on_can) {
    queue_.push(pack_drive(configuration_.node.node, {0, 0, DriveState::kStopped}));
  }
  if (!measuring_ || listening_) return;
  estimation_.end_level();
  measuring_ = false;
}

void RigController::set_relay(bool active) {
  if (ports_.relay.set(active)) {
    relay_on_ = active;
    return;
  }
  handle(supervisor_.trip({AlarmCause::kRelayNotTaken}));
}

void RigController::set_ready_lamp() {
  const bool on = !supervisor_.tripped();
  if (lamp_known_ && on == lamp_on_) return;
  lamp_known_ = ports_.ready_lamp.set(on);
  lamp_on_ = on;
}

ControllerMode RigController::mode() const {
  if (!booted_) return ControllerMode::kInitialising;
  if (supervisor_.latched().cause == AlarmCause::kEmergencyStop) return ControllerMode::kEmergencyStop;
  if (supervisor_.tripped()) return ControllerMode::kFault;
  if (listening_)
    return measuring_ ? ControllerMode::kIntegrate : finished_ ? ControllerMode::kDone : ControllerMode::kIdle;
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
