#include "host_sim/live/screen/status_lines.hpp"

#include <cstdio>

#include "host_sim/can_log/readable.hpp"

namespace live {
namespace {

namespace can = firmware::can;

std::string clock_text(uint64_t seconds) {
  char text[48];
  std::snprintf(text, sizeof text, "%llu:%02llu:%02llu", static_cast<unsigned long long>(seconds / 3600),
                static_cast<unsigned long long>(seconds / 60 % 60), static_cast<unsigned long long>(seconds % 60));
  return text;
}

Span bus_words(const BusPicture& picture, bool ended) {
  const BusLink& link = picture.link();
  const std::string away = " " + duration_text(time_since(link.phase_since_ns(), picture.now_ns()));
  if (ended) return {"end of the log", Role::kHead};
  switch (link.phase()) {
    case BusPhase::kWaiting:
      return {"waiting for the first frame", Role::kDoubtful};
    case BusPhase::kUp:
      return {"bus up", Role::kGood};
    case BusPhase::kSilent:
      return {"BUS SILENT for" + away, Role::kBad};
    case BusPhase::kOff:
      return {"BUS-OFF for" + away, Role::kBad};
    case BusPhase::kDown:
      break;
  }
  return {"INTERFACE DOWN for" + away, Role::kBad};
}

Span count_field(const std::string& what, uint64_t count) {
  return {what + " " + std::to_string(count), count > 0 ? Role::kDoubtful : Role::kPlain};
}

void add_status(const NodeState& node, std::vector<Span>& fields) {
  if (!node.status) return;
  const std::string mode = can_log::state_name(can::states(can::kModes), static_cast<int64_t>(node.status->mode));
  const bool stopped = mode == "EMERGENCY_STOP" || mode == "FAULT";
  fields.push_back({mode, stopped ? Role::kBad : Role::kPlain});
  const std::string faults = can_log::flag_names(can::flags(can::kFaults), node.status->faults);
  fields.push_back({"faults: " + faults, node.status->faults != 0 ? Role::kBad : Role::kPlain});
}

void add_health(const NodeState& node, std::vector<Span>& fields) {
  if (node.health) {
    fields.push_back({"up " + clock_text(node.health->uptime_s), Role::kPlain});
    fields.push_back(count_field("missed samples", node.health->core.missed_samples));
    fields.push_back(count_field("saturated", node.health->core.saturated_samples));
    if (node.health->bus_off > 0) fields.push_back(count_field("bus-off", node.health->bus_off));
  }
  if (node.bus_health) {
    fields.push_back(count_field("sensor frames lost", node.bus_health->sensor_frames_lost));
    if (node.bus_health->frames_not_sent > 0)
      fields.push_back(count_field("frames not sent", node.bus_health->frames_not_sent));
  }
}

}  // namespace

std::string duration_text(uint64_t duration_ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", static_cast<double>(duration_ns) / 1e9);
  return text;
}

uint64_t time_since(uint64_t then_ns, uint64_t now_ns) { return now_ns > then_ns ? now_ns - then_ns : 0; }

std::vector<Span> bus_fields(const BusPicture& picture, bool ended) {
  const BusLink& link = picture.link();
  char load[64], rate[64];
  std::snprintf(load, sizeof load, "load at most %.1f %%", link.load_percent());
  std::snprintf(rate, sizeof rate, "%.0f frames/s", link.frames_per_s());
  std::vector<Span> fields = {bus_words(picture, ended), {load, Role::kPlain}, {rate, Role::kPlain}};
  fields.push_back({std::to_string(link.frames()) + " frames", Role::kPlain});
  if (link.error_frames() > 0)
    fields.push_back({std::to_string(link.error_frames()) + " error frames", Role::kDoubtful});
  if (link.absences() > 0) fields.push_back({"away " + std::to_string(link.absences()) + "x", Role::kDoubtful});
  return fields;
}

std::vector<Span> node_fields(const BusPicture& picture, int number) {
  const NodeState& node = picture.node(number);
  std::vector<Span> fields = {{"node " + std::to_string(number), Role::kHead}};
  if (!node.heard) {
    fields.push_back({"not heard", Role::kDoubtful});
    return fields;
  }
  if (picture.node_silent(number)) {
    fields.push_back({"SILENT for " + duration_text(time_since(node.last_frame_ns, picture.now_ns())), Role::kBad});
  } else if (!node.heartbeat.empty()) {
    fields.push_back({node.heartbeat, node.heartbeat == "STOPPED" ? Role::kBad : Role::kGood});
  }
  add_status(node, fields);
  add_health(node, fields);
  if (node.window)
    fields.push_back({"window " + std::to_string(node.window->window) + ", residual " +
                          can_log::number_text(node.window->residual_e9 * 1e-9, 3),
                      Role::kPlain});
  if (node.status) fields.push_back({"condition 2^" + std::to_string(node.status->condition_log2), Role::kPlain});
  return fields;
}

Span diagnosis_field(const NodeState& node) {
  if (!node.diagnosis) return {"diagnosis: none sent yet", Role::kQuiet};
  const bool none = node.diagnosis->cause == firmware::Cause::kNone;
  char share[80];
  std::snprintf(share, sizeof share, " (unexplained %.1f %%)", node.diagnosis->unexplained_permille / 10.0);
  return {"diagnosis: " + diagnosis_words(*node.diagnosis) + share, none ? Role::kGood : Role::kDoubtful};
}

Span event_field(const Event& event, uint64_t start_ns) {
  const std::string who = event.node > 0 ? "node " + std::to_string(event.node) : "bus   ";
  return {padded(duration_text(time_since(start_ns, event.time_ns)), 9, true) + "  " + who + "  " + event.text,
          event.bad ? Role::kBad : Role::kPlain};
}

}  // namespace live
