// What is known of the rig from the frames that have passed: nodes, estimates, alarms, the wire. A state made from
// frames and time alone, so that the same log gives the same picture.
#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/can_log/known_names.hpp"
#include "host_sim/live/state/bus_link.hpp"
#include "host_sim/live/state/trend.hpp"

namespace live {

struct EstimateState {
  int index = 0;
  double value = 0.0, std = 0.0;
  std::string status;  // empty: not seen yet
  uint64_t time_ns = 0;
  Trend trend;
};

struct NodeState {
  bool heard = false;
  uint64_t last_frame_ns = 0;
  std::string heartbeat;  // "OPERATIONAL"; empty: none seen
  std::optional<firmware::NodeStatus> status;
  std::optional<firmware::NodeHealth> health;
  std::optional<firmware::BusHealth> bus_health;
  std::optional<firmware::Identity> identity;
  std::optional<firmware::WindowResult> window;
  std::optional<firmware::Diagnosis> diagnosis;
  std::vector<EstimateState> estimates;  // by index, without gaps at the end
};

struct Event {
  uint64_t time_ns = 0;
  int node = 0;  // 0: the bus
  std::string text;
  bool bad = true;
};

struct PictureOptions {
  BitRates rates;
  uint64_t trend_ns = 180000000000;
};

class BusPicture {
 public:
  static constexpr size_t kMostEvents = 100;
  static constexpr uint64_t kNodeSilence_ns = 1000000000;

  explicit BusPicture(const PictureOptions& options = {}) : options_(options), link_(options.rates) {}

  void take(const can_log::LogEntry& entry);
  void advance(uint64_t now_ns);  // nothing came until now
  void link_down(uint64_t now_ns);

  uint64_t now_ns() const { return now_ns_; }
  uint64_t start_ns() const { return start_ns_; }
  const PictureOptions& options() const { return options_; }
  const BusLink& link() const { return link_; }
  std::vector<int> nodes() const;  // that have been heard, rising
  const NodeState& node(int number) const { return nodes_[number]; }
  bool node_silent(int number) const;
  const std::deque<Event>& events() const { return events_; }  // the oldest first
  std::string estimate_name(int node, int index) const { return names_.parameter(node, index); }
  std::string estimate_unit(int node, int index) const { return names_.unit(node, index); }

 private:
  void tell(int node, const std::string& text, bool bad = true);
  void take_known(const firmware::can::Address& address, const firmware::CanFrame& message);
  void take_reports(NodeState& node, const firmware::CanFrame& message);
  void take_estimate(NodeState& node, int index, const firmware::CanFrame& message, int bit_offset);

  PictureOptions options_;
  BusLink link_;
  can_log::KnownNames names_;
  NodeState nodes_[firmware::can::kLastNode + 1];
  std::deque<Event> events_;
  uint64_t now_ns_ = 0, start_ns_ = 0;
  bool started_ = false;
};

// "cubic_stiffness on link 1-2", "sensor_delay on channel velocity[2]", "NONE".
std::string diagnosis_words(const firmware::Diagnosis& diagnosis);
// "SENSOR_SATURATED, velocity[3], 1000 times".
std::string emergency_words(const firmware::Emergency& emergency);

}  // namespace live
