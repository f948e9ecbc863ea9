// The frames of the controller: each struct of messages.hpp in the order of its signals in the table.
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/messages/raw_values.hpp"

namespace firmware {

CanFrame pack_sync() { return can::empty_frame(can::kSync, 0); }

bool is_sync(const CanFrame& message) {
  int node = 0, member = 0;
  return can::is_frame(can::kSync, message, node, member);
}

CanFrame pack_network_command(const NetworkCommand& command) {
  return can::pack<can::kNetworkCommand>(0, 0, {static_cast<int64_t>(command.command), command.node});
}

bool unpack_network_command(const CanFrame& message, NetworkCommand& command) {
  int64_t raw[2];
  int node = 0;
  if (!unpack(can::kNetworkCommand, message, node, raw)) return false;
  assign(command.command, raw[0]);
  assign(command.node, raw[1]);
  return true;
}

CanFrame pack_heartbeat(int node, HeartbeatState state) {
  return can::pack<can::kHeartbeat>(node, 0, {static_cast<int64_t>(state)});
}

bool unpack_heartbeat(const CanFrame& message, int& node, HeartbeatState& state) {
  int64_t raw[1];
  if (!unpack(can::kHeartbeat, message, node, raw)) return false;
  assign(state, raw[0]);
  return true;
}

CanFrame pack_emergency(int node, const Emergency& emergency) {
  return can::pack<can::kEmergency>(node, 0,
                                    {static_cast<int64_t>(emergency.code), emergency.error_register, emergency.place,
                                     emergency.quantity, emergency.detail});
}

bool unpack_emergency(const CanFrame& message, int& node, Emergency& emergency) {
  int64_t raw[5];
  if (!unpack(can::kEmergency, message, node, raw)) return false;
  assign(emergency.code, raw[0]);
  assign(emergency.error_register, raw[1]);
  assign(emergency.place, raw[2]);
  assign(emergency.quantity, raw[3]);
  assign(emergency.detail, raw[4]);
  return true;
}

CanFrame pack_status(int node, const NodeStatus& status) {
  return can::pack<can::kStatus>(node, 0,
                                 {status.faults, static_cast<int64_t>(status.mode),
                                  static_cast<int64_t>(status.quality), status.condition_log2, status.update_counter});
}

bool unpack_status(const CanFrame& message, int& node, NodeStatus& status) {
  int64_t raw[5];
  if (!unpack(can::kStatus, message, node, raw)) return false;
  assign(status.faults, raw[0]);
  assign(status.mode, raw[1]);
  assign(status.quality, raw[2]);
  assign(status.condition_log2, raw[3]);
  assign(status.update_counter, raw[4]);
  return true;
}

CanFrame pack_health(int node, const NodeHealth& health) {
  return can::pack<can::kHealth>(
      node, 0, {health.uptime_s, health.core.missed_samples, health.core.saturated_samples, health.bus_off});
}

bool unpack_health(const CanFrame& message, int& node, NodeHealth& health) {
  int64_t raw[4];
  if (!unpack(can::kHealth, message, node, raw)) return false;
  assign(health.uptime_s, raw[0]);
  assign(health.core.missed_samples, raw[1]);
  assign(health.core.saturated_samples, raw[2]);
  assign(health.bus_off, raw[3]);
  return true;
}

CanFrame pack_bus_health(int node, const BusHealth& health) {
  return can::pack<can::kBusHealth>(node, 0,
                                    {health.restarts, health.error_passive, health.controller_overflow,
                                     health.interface_down, health.frames_not_sent, health.sensor_frames_lost});
}

bool unpack_bus_health(const CanFrame& message, int& node, BusHealth& health) {
  int64_t raw[6];
  if (!unpack(can::kBusHealth, message, node, raw)) return false;
  assign(health.restarts, raw[0]);
  assign(health.error_passive, raw[1]);
  assign(health.controller_overflow, raw[2]);
  assign(health.interface_down, raw[3]);
  assign(health.frames_not_sent, raw[4]);
  assign(health.sensor_frames_lost, raw[5]);
  return true;
}

CanFrame pack_identity(int node, const Identity& identity) {
  return can::pack<can::kIdentity>(node, 0,
                                   {identity.version_major, identity.version_minor, identity.version_patch,
                                    identity.parameters, identity.configuration_crc});
}

bool unpack_identity(const CanFrame& message, int& node, Identity& identity) {
  int64_t raw[5];
  if (!unpack(can::kIdentity, message, node, raw)) return false;
  assign(identity.version_major, raw[0]);
  assign(identity.version_minor, raw[1]);
  assign(identity.version_patch, raw[2]);
  assign(identity.parameters, raw[3]);
  assign(identity.configuration_crc, raw[4]);
  return true;
}

CanFrame pack_window(int node, const WindowResult& window) {
  return can::pack<can::kWindow>(node, 0, {window.residual_e9, window.equations, window.window & 0xFFFF});
}

bool unpack_window(const CanFrame& message, int& node, WindowResult& window) {
  int64_t raw[3];
  if (!unpack(can::kWindow, message, node, raw)) return false;
  assign(window.residual_e9, raw[0]);
  assign(window.equations, raw[1]);
  assign(window.window, raw[2]);
  return true;
}

CanFrame pack_drive(int node, const DriveCommand& drive) {
  return can::pack<can::kDrive>(node, 0, {drive.drive_q31, drive.sequence & 0xFFFF, static_cast<int64_t>(drive.state)});
}

bool unpack_drive(const CanFrame& message, int& node, DriveCommand& drive) {
  int64_t raw[3];
  if (!unpack(can::kDrive, message, node, raw)) return false;
  assign(drive.drive_q31, raw[0]);
  assign(drive.sequence, raw[1]);
  assign(drive.state, raw[2]);
  return true;
}

}  // namespace firmware
