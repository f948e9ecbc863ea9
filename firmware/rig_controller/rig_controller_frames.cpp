// What RigController sends and receives. Layouts: firmware/can_protocol/frame_table.hpp.
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "firmware/version.hpp"

namespace firmware {
namespace {

constexpr uint64_t kMillisecond_ns = 1000000;

}  // namespace

// result: of the first one.
void RigController::receive_frames(hal::CanResult result) {
  for (int taken = 1; result == hal::CanResult::kDone; ++taken) {
    receive(frame_);
    if (taken == kFramesPerStep) return;
    result = ports_.can.receive(frame_);
  }
  if (result == hal::CanResult::kBusDown) follow(bus_.answer(result, now_ns_));
}

void RigController::receive(const hal::CanFrame& frame) {
  if (frame.error) return follow(bus_.error_frame(frame, now_ns_));
  follow(bus_.frame_received());
  if (frame.remote) return;
  CanFrame reply;
  NetworkCommand command;
  if (unpack_network_command(frame, command)) return follow(command);
  if (is_sync(frame)) {
    if (configuration_.node.sync_closes_window) measurement_.close_begun_window();
    return take_results();
  }
  if (sdo_.answer(frame, configuration_.node.node, reply)) queue_.push(reply, false);
  handle(objects_.take_alarm());
}

void RigController::check_save() {
  SdoAbort answer = SdoAbort::kNone;
  if (objects_.take_saved(answer)) queue_.push(sdo_.complete(answer), false);
  handle(objects_.take_alarm());
}

void RigController::follow(const NetworkCommand& command) {
  if (command.node != 0 && command.node != configuration_.node.node) return;
  switch (command.command) {
    case NetworkCommandCode::kStart:
      start();
      break;
    case NetworkCommandCode::kStop:
      stop();
      break;
    case NetworkCommandCode::kReset:
      reset();
      break;
  }
}

void RigController::check_sync_edge() {
  hal::LineEdge edge;
  for (int taken = 0; taken < kEdgesPerStep && ports_.sync_edge->next_edge(edge); ++taken) {
    if (edge.rising && configuration_.node.sync_closes_window) measurement_.close_begun_window();
    take_results();
  }
}

void RigController::take_results() {
  if (!measurement_.take_result()) return;
  const Estimation::Results& results = measurement_.results();
  windows_.send(results.estimates, results.judge_asked);
}

void RigController::run_schedule() {
  if (schedule_.heartbeat.due(now_ns_)) send_heartbeat();
  if (schedule_.status.due(now_ns_)) send_status();
  if (schedule_.second.due(now_ns_)) {
    send_health();
    tell_overflows();
    windows_.repeat_diagnosis();
    descriptions_.tell_parameters();
  }
  if (schedule_.five_seconds.due(now_ns_)) descriptions_.tell_channels();
  schedule_.settle();
}

// What waits for room in the transmit queue, the most urgent last: it goes in front.
void RigController::send_waiting() {
  windows_.send_some_floats();
  descriptions_.send_some();
  send_alarms();
}

void RigController::send_heartbeat() {
  const HeartbeatState state = safe_.tripped() ? HeartbeatState::kStopped : HeartbeatState::kOperational;
  const CanFrame heartbeat = pack_heartbeat(configuration_.node.node, state);
  if (queue_.byte_of(heartbeat.id, 0) != static_cast<int>(HeartbeatState::kBootUp)) queue_.push(heartbeat);
}

uint16_t RigController::fault_bits() const {
  uint32_t bits = status_bit(safe_.latched().cause) | passing_faults_;
  if (bus_.state() == BusState::kPassive) bits |= fault_bit(Fault::kCanErrorPassive);
  if (bus_.state() == BusState::kBusOff) bits |= fault_bit(Fault::kCanBusOff);
  if (objects_.store_damaged()) bits |= fault_bit(Fault::kStore);
  const Estimates* estimates = windows_.estimates();
  for (int i = 0; estimates != nullptr && i < estimates->unknown_count; ++i)
    if (estimates->parameters[i].status == EstimateStatus::kSaturated) bits |= fault_bit(Fault::kAccumulatorSaturated);
  return static_cast<uint16_t>(bits);
}

void RigController::send_status() {
  queue_.push(pack_status(configuration_.node.node, node_status(windows_.estimates(), mode(), fault_bits())));
  passing_faults_ = 0;
}

void RigController::send_health() {
  const uint8_t node = configuration_.node.node;
  NodeHealth health;
  health.uptime_s = static_cast<uint32_t>((now_ns_ - boot_ns_) / 1000000000);
  health.core = measurement_.estimation().health();
  health.core.missed_samples = supervisor_.counters().missed_samples + measurement_.estimation().dropped_samples();
  health.core.saturated_samples = supervisor_.counters().saturated_samples;
  health.bus_off = bus_.bus_off_count();
  queue_.push(pack_health(node, health));
  BusHealth bus_health = bus_.health();
  bus_health.frames_not_sent = queue_.given_up();
  bus_health.sensor_frames_lost = ports_.samples.frames_lost();
  queue_.push(pack_bus_health(node, bus_health));
  Identity identity;
  identity.version_major = kVersionMajor;
  identity.version_minor = kVersionMinor;
  identity.version_patch = kVersionPatch;
  identity.parameters = configuration_.core.unknown_count;
  identity.configuration_crc = objects_.configuration_crc();
  queue_.push(pack_identity(node, identity));
}

// What was dropped because this program came too late to fetch it.
void RigController::tell_overflows() {
  const uint32_t overflows = ports_.can.receive_overflows() + ports_.samples.overflows();
  if (overflows == reported_overflows_) return;
  reported_overflows_ = overflows;
  handle({AlarmCause::kCanOverflow, overflows});
}

// One emergency frame at a time stands in the transmit queue; the others wait here, where equal ones become one.
void RigController::send_alarms() {
  if (!bus_.may_send()) return;
  if (queue_.given_up() != reported_drops_ && queue_.waiting() == 0) {
    reported_drops_ = queue_.given_up();
    handle({AlarmCause::kCanOverflow, reported_drops_});
  }
  const uint8_t node = configuration_.node.node;
  const uint64_t inhibit_ns = configuration_.node.emergency_inhibit_ms * kMillisecond_ns;
  Emergency emergency;
  while (!queue_.has(can::frame_id(can::kEmergency.ids, node)) && alarms_.pop(now_ns_, inhibit_ns, emergency)) {
    queue_.push(pack_emergency(node, emergency), false);
  }
}

// While the bus is away only the newest of each kind is kept; what has to be told again is told on its return.
void RigController::flush_queue() {
  if (bus_.trial_due(now_ns_)) follow(bus_.answer(queue_.flush(ports_.can), now_ns_));
}

void RigController::follow(BusEvent event) {
  switch (event) {
    case BusEvent::kNone:
      break;
    case BusEvent::kBecamePassive:
      handle({AlarmCause::kCanErrorPassive, bus_.health().error_passive});
      break;
    case BusEvent::kOverflow:
      handle({AlarmCause::kCanOverflow, bus_.health().controller_overflow});
      break;
    case BusEvent::kWentOff:
    case BusEvent::kWentDown:
      break;
    case BusEvent::kRecovered:
      handle({AlarmCause::kCanRecovered, bus_.recoveries()});
      if (configuration_.node.heartbeat_ms != 0) send_heartbeat();
      send_status();
      break;
  }
}

}  // namespace firmware
