#include "host_sim/live/state/bus_picture.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/readable.hpp"

namespace live {
namespace {

namespace can = firmware::can;
using firmware::CanFrame;

template <typename Value>
bool keep(bool (*unpack)(const CanFrame&, int&, Value&), const CanFrame& message, std::optional<Value>& kept) {
  int node = 0;
  Value value;
  if (!unpack(message, node, value)) return false;
  kept = value;
  return true;
}

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }

}  // namespace

std::string diagnosis_words(const firmware::Diagnosis& diagnosis) {
  std::string cause = can_log::state_name(can::states(can::kCauses), static_cast<int64_t>(diagnosis.cause));
  if (cause.empty()) cause = "cause " + std::to_string(static_cast<int>(diagnosis.cause));
  if (diagnosis.quantity != firmware::kNoQuantity)
    return cause + " on channel " + can_log::channel_label(diagnosis.place_a, diagnosis.quantity);
  if (diagnosis.place_b != can::kPlaceNone)
    return cause + " on link " + can_log::place_label(diagnosis.place_a) + "-" +
           can_log::place_label(diagnosis.place_b);
  if (diagnosis.place_a != can::kPlaceNone) return cause + " on dof " + can_log::place_label(diagnosis.place_a);
  return cause;
}

std::string emergency_words(const firmware::Emergency& emergency) {
  std::string text = can_log::state_name(can::states(can::kEmergencyCodes), static_cast<int64_t>(emergency.code));
  if (text.empty()) text = can_log::hex_text(static_cast<uint64_t>(emergency.code), 4);
  if (emergency.quantity != firmware::kNoQuantity) {
    text += ", " + can_log::channel_label(emergency.place, emergency.quantity);
  } else if (emergency.place != can::kPlaceNone) {
    text += ", DOF " + can_log::place_label(emergency.place);
  }
  return emergency.detail > 0 ? text + " (" + std::to_string(emergency.detail) + ")" : text;
}

void BusPicture::tell(int node, const std::string& text, bool bad) {
  if (text.empty()) return;
  events_.push_back({now_ns_, node, text, bad});
  if (events_.size() > kMostEvents) events_.pop_front();
}

// Frames of a log come with their own times: a gap between two of them is silence too, though nobody waited.
void BusPicture::take(const can_log::LogEntry& entry) {
  const uint64_t time_ns = entry.frame.time_ns;
  if (started_ && time_ns > link_.last_frame_ns() + BusLink::kSilence_ns)
    advance(link_.last_frame_ns() + BusLink::kSilence_ns + 1);
  const bool anew = time_ns + BusLink::kSilence_ns < now_ns_;  // another log
  if (!started_ || anew) start_ns_ = time_ns;
  started_ = true;
  now_ns_ = anew ? time_ns : std::max(now_ns_, time_ns);
  const std::string news = link_.take(entry);
  tell(0, news, link_.phase() != BusPhase::kUp || entry.frame.error);
  if (entry.frame.error || entry.frame.remote) return;
  const CanFrame message = can_log::to_message(entry.frame);
  names_.learn(message);
  const can::Address address = can::identify(message);
  if (address.frame != nullptr && address.node > 0 && address.frame->sender == can::Sender::kController)
    take_known(address, message);
}

void BusPicture::advance(uint64_t now_ns) {
  if (now_ns <= now_ns_ || !started_) return;
  now_ns_ = now_ns;
  tell(0, link_.advance(now_ns));
}

void BusPicture::link_down(uint64_t now_ns) {
  if (now_ns > now_ns_) now_ns_ = now_ns;
  if (!started_) start_ns_ = now_ns_;
  started_ = true;
  tell(0, link_.went_down(now_ns_));
}

void BusPicture::take_known(const can::Address& address, const CanFrame& message) {
  NodeState& node = nodes_[address.node];
  node.heard = true;
  node.last_frame_ns = now_ns_;
  if (address.frame == &can::kEstimate) return take_estimate(node, address.member, message, 0);
  if (address.frame == &can::kEstimateFd) {
    for (int i = 0; i < can::kEstimateFd.repeats; ++i)
      take_estimate(node, address.member * can::kEstimateFd.repeats + i, message,
                    i * can::record_bits(can::kEstimateFd));
    return;
  }
  int number = 0;
  firmware::HeartbeatState beat;
  firmware::Emergency emergency;
  if (firmware::unpack_heartbeat(message, number, beat)) {
    node.heartbeat = can_log::state_name(can::states(can::kHeartbeatStates), static_cast<int64_t>(beat));
    if (beat == firmware::HeartbeatState::kBootUp) tell(number, "started", false);
  } else if (firmware::unpack_emergency(message, number, emergency)) {
    const bool bad = emergency.code != firmware::EmergencyCode::kNoError &&
                     emergency.code != firmware::EmergencyCode::kCanBusOffRecovered;
    tell(number, emergency_words(emergency), bad);
  } else {
    take_reports(node, message);
  }
}

void BusPicture::take_reports(NodeState& node, const CanFrame& message) {
  keep(firmware::unpack_status, message, node.status) || keep(firmware::unpack_health, message, node.health) ||
      keep(firmware::unpack_bus_health, message, node.bus_health) ||
      keep(firmware::unpack_identity, message, node.identity) || keep(firmware::unpack_window, message, node.window) ||
      keep(firmware::unpack_diagnosis, message, node.diagnosis);
}

void BusPicture::take_estimate(NodeState& node, int index, const CanFrame& message, int bit_offset) {
  const firmware::EstimateRecord record = firmware::record_at(message, bit_offset);
  const std::string status = can_log::state_name(can::states(can::kQualityStates), static_cast<int64_t>(record.status));
  if (firmware::is_absent(record)) return;
  while (static_cast<int>(node.estimates.size()) <= index) {
    node.estimates.emplace_back();
    node.estimates.back().index = static_cast<int>(node.estimates.size()) - 1;
  }
  EstimateState& estimate = node.estimates[static_cast<size_t>(index)];
  estimate.value = record.value * power_of_ten(record.exponent);
  estimate.std = record.std * power_of_ten(record.exponent + record.std_exponent);
  estimate.status = status;
  estimate.time_ns = now_ns_;
  estimate.trend.add(now_ns_, estimate.value, options_.trend_ns);
}

std::vector<int> BusPicture::nodes() const {
  std::vector<int> heard;
  for (int number = can::kFirstNode; number <= can::kLastNode; ++number)
    if (nodes_[number].heard) heard.push_back(number);
  return heard;
}

bool BusPicture::node_silent(int number) const { return now_ns_ > nodes_[number].last_frame_ns + kNodeSilence_ns; }

}  // namespace live
