// What RigController sends and receives. Layouts: firmware/can_protocol/frame_table.hpp.
#include "firmware/can_protocol/estimate_frames.hpp"
#include "firmware/can_protocol/packing.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "firmware/version.hpp"

namespace firmware {
namespace {

constexpr uint64_t kMillisecond_ns = 1000000, kJudgement_ns = 1000 * kMillisecond_ns;
constexpr int kEnoughRoom = TransmitQueue::kCapacity / 2;  // in the queue, for what is not urgent

}  // namespace

void RigController::receive_frames() {
  hal::CanFrame frame;
  for (int taken = 0; taken < kFramesPerStep; ++taken) {
    const hal::CanResult result = ports_.can.receive(frame);
    if (result != hal::CanResult::kDone) {
      if (result == hal::CanResult::kBusDown) follow(bus_.answer(result, now_ns_));
      return;
    }
    receive(frame);
  }
}

void RigController::receive(const hal::CanFrame& frame) {
  if (frame.error) return follow(bus_.error_frame(frame, now_ns_));
  follow(bus_.frame_received());
  if (frame.remote) return;
  CanFrame reply;
  NetworkCommand command;
  if (unpack_network_command(frame, command)) return follow(command);
  if (is_sync(frame)) {
    if (configuration_.node.sync_closes_window && measuring_ && samples_in_window_ > 0) close_window();
    return;
  }
  if (sdo_.answer(frame, configuration_.node.node, reply)) queue_.push(reply, false);
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
  if (ports_.sync_edge == nullptr) return;
  hal::LineEdge edge;
  for (int taken = 0; taken < kEdgesPerStep && ports_.sync_edge->next_edge(edge); ++taken) {
    const bool closes = edge.rising && configuration_.node.sync_closes_window;
    if (closes && measuring_ && samples_in_window_ > 0) close_window();
  }
}

void RigController::close_window() {
  samples_in_window_ = 0;
  // The diagnosis is told once a second and at the end of each level.
  const bool judge = now_ns_ >= next_judgement_ns_ || !measuring_;
  if (judge) next_judgement_ns_ = now_ns_ + kJudgement_ns;
  estimation_.solve(judge);
  take_results();
}

void RigController::take_results() {
  if (!estimation_.take_result()) return;
  const Estimation::Results& results = estimation_.results();
  estimates_ = &results.estimates;
  send_estimates();
  if (results.judge_asked) tell_judgement(results.estimates.warrant.tested, diagnosis_of(results.estimates));
}

// At once where it has changed.
void RigController::tell_judgement(bool judged, const Diagnosis& judgement) {
  const bool changed = judgement.cause != diagnosis_.cause || judgement.place_a != diagnosis_.place_a ||
                       judgement.place_b != diagnosis_.place_b || judgement.quantity != diagnosis_.quantity;
  const bool told = judged && (changed || !judged_);
  judged_ = judged;
  if (judged) diagnosis_ = judgement;
  if (told) send_diagnosis();
}

void RigController::send_diagnosis() {
  const uint8_t node = configuration_.node.node;
  queue_.push(pack_diagnosis(node, diagnosis_));
  if (diagnosis_.cause == Cause::kNone) return;
  queue_.push(pack_diagnosis_size(node, diagnosis_));
  queue_.push(pack_diagnosis_rival(node, diagnosis_));
}

void RigController::send_estimates() {
  const uint8_t node = configuration_.node.node;
  const Estimates& estimates = *estimates_;
  queue_.push(pack_window(node, window_result(estimates)));
  next_float_ = 0;
  if (configuration_.node.can_fd) {
    for (int i = 0; i < fd_frames(estimates.unknown_count); ++i) queue_.push(pack_estimates_fd(node, i, estimates));
    return;
  }
  for (int i = 0; i < estimates.unknown_count; ++i) {
    queue_.push(pack_estimate(node, i, estimates.parameters[i], estimates.window_counter));
  }
}

void RigController::run_schedule() {
  if (heartbeat_.due(now_ns_)) send_heartbeat();
  if (status_.due(now_ns_)) send_status();
  if (second_.due(now_ns_)) {
    send_health();
    tell_overflows();
    if (judged_) send_diagnosis();
    next_parameter_ = 0;
  }
  if (five_seconds_.due(now_ns_)) next_channel_ = 0;
  send_some_floats();
  describe_some();
  send_alarms();
}

// The estimates of the last window as floats, a few at a time: they say nothing new, so all else goes first.
void RigController::send_some_floats() {
  if (estimates_ == nullptr || !sends_float_estimates(configuration_)) return;
  const NodeConfiguration& node = configuration_.node;
  const int count = node.can_fd ? fd_frames(estimates_->unknown_count) : estimates_->unknown_count;
  for (; next_float_ < count && queue_.room() > kEnoughRoom; ++next_float_) {
    queue_.push(node.can_fd ? pack_estimates_float_fd(node.node, next_float_, *estimates_)
                            : pack_estimate_float(node.node, next_float_, estimates_->parameters[next_float_]));
  }
}

// The descriptions of parameters and channels go out a few at a time, behind everything else.
void RigController::describe_some() {
  const CoreConfiguration& core = configuration_.core;
  const auto rotating = [this](int node) { return node < 32 && (configuration_.node.rotating_nodes >> node & 1) != 0; };
  while (next_parameter_ < core.unknown_count && queue_.room() > kEnoughRoom) {
    ParameterDescription description;
    const int unknown = next_parameter_++;
    if (!describe_parameter(core, unknown, false, description)) continue;
    const int node = description.place_a > 0 ? description.place_a - 1 : 0;
    describe_parameter(core, unknown, rotating(node), description);
    queue_.push(pack_parameter(configuration_.node.node, description), false);
  }
  while (next_channel_ < kMaxNodes * kQuantities && queue_.room() > kEnoughRoom) {
    const int node = next_channel_ / kQuantities;
    const auto quantity = static_cast<Quantity>(next_channel_ % kQuantities);
    ++next_channel_;
    const ChannelConfiguration& channel = core.channels[node][static_cast<int>(quantity)];
    if (!channel.present) continue;
    queue_.push(pack_scaling(configuration_.node.node, channel_scaling(channel, node, quantity, rotating(node))),
                false);
    queue_.push(pack_range(configuration_.node.node, channel_range(channel, node, quantity, rotating(node))), false);
  }
}

void RigController::send_heartbeat() {
  const HeartbeatState state = safe_.tripped() ? HeartbeatState::kStopped : HeartbeatState::kOperational;
  const CanFrame heartbeat = pack_heartbeat(configuration_.node.node, state);
  const CanFrame* waiting = queue_.find(heartbeat.id);
  const bool boot_up_waits = waiting != nullptr && waiting->data[0] == static_cast<uint8_t>(HeartbeatState::kBootUp);
  if (!boot_up_waits) queue_.push(heartbeat);
}

uint16_t RigController::fault_bits() const {
  uint32_t bits = status_bit(safe_.latched().cause) | passing_faults_;
  if (bus_.state() == BusState::kPassive) bits |= fault_bit(Fault::kCanErrorPassive);
  if (bus_.state() == BusState::kBusOff) bits |= fault_bit(Fault::kCanBusOff);
  if (settings_.damaged()) bits |= fault_bit(Fault::kStore);
  if (estimates_ != nullptr) {
    for (int i = 0; i < estimates_->unknown_count; ++i) {
      if (estimates_->parameters[i].status == EstimateStatus::kSaturated)
        bits |= fault_bit(Fault::kAccumulatorSaturated);
    }
  }
  return static_cast<uint16_t>(bits);
}

uint8_t RigController::error_register() const {
  uint32_t bits = error_register_bit(safe_.latched().cause);
  if (bus_.state() != BusState::kGood) bits |= error_register_bit(AlarmCause::kCanErrorPassive);
  if (settings_.damaged()) bits |= error_register_bit(AlarmCause::kStore);
  return static_cast<uint8_t>(bits != 0 ? bits | 1 : 0);
}

void RigController::send_status() {
  static const Estimates kNone;  // nothing has been estimated yet
  const Estimates& estimates = estimates_ != nullptr ? *estimates_ : kNone;
  queue_.push(pack_status(configuration_.node.node, node_status(estimates, mode(), fault_bits())));
  passing_faults_ = 0;
}

void RigController::send_health() {
  const uint8_t node = configuration_.node.node;
  NodeHealth health;
  health.uptime_s = static_cast<uint32_t>((now_ns_ - boot_ns_) / 1000000000);
  health.core = estimation_.health();
  health.core.missed_samples = supervisor_.counters().missed_samples + estimation_.dropped_samples();
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
  identity.configuration_crc = configuration_crc_;
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
  while (queue_.find(can::frame_id(can::kEmergency.ids, node)) == nullptr &&
         alarms_.pop(now_ns_, inhibit_ns, emergency)) {
    queue_.push(pack_emergency(node, emergency), false);
  }
}

// While the bus is away only the newest of each kind is kept; what has to be told again is told on its return.
void RigController::flush_queue() {
  if (bus_.trial_due(now_ns_)) follow(bus_.answer(queue_.flush(ports_.can), now_ns_));
  handle(safe_.check_delivery());
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
