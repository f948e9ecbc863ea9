// The frames of the controller: each struct of messages.hpp in the order of its signals in the table.
#include "firmware/can_protocol/packing.hpp"

namespace firmware {
namespace {

// The raw values of a frame in the order of the table, or false where the message is another.
template <size_t N>
bool unpack(const can::Frame& frame, const CanFrame& message, int& node, int64_t (&raw)[N]) {
  int member = 0;
  if (!can::is_frame(frame, message, node, member)) return false;
  for (size_t i = 0; i < N; ++i) raw[i] = can::get_raw(message, frame.signals[i]);
  return true;
}

template <typename T>
void assign(T& field, int64_t raw) {
  field = static_cast<T>(raw);
}

}  // namespace

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

CanFrame pack_diagnosis(int node, const Diagnosis& diagnosis) {
  return can::pack<can::kDiagnosis>(node, 0,
                                    {static_cast<int64_t>(diagnosis.cause), diagnosis.place_a, diagnosis.place_b,
                                     diagnosis.quantity, diagnosis.unexplained_permille, diagnosis.gained_permille});
}

bool unpack_diagnosis(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[6];
  if (!unpack(can::kDiagnosis, message, node, raw)) return false;
  assign(diagnosis.cause, raw[0]);
  assign(diagnosis.place_a, raw[1]);
  assign(diagnosis.place_b, raw[2]);
  assign(diagnosis.quantity, raw[3]);
  assign(diagnosis.unexplained_permille, raw[4]);
  assign(diagnosis.gained_permille, raw[5]);
  return true;
}

CanFrame pack_diagnosis_size(int node, const Diagnosis& diagnosis) {
  const DecimalSize& size = diagnosis.size;
  return can::pack<can::kDiagnosisSize>(
      node, 0, {size.value, size.std, size.exponent - can::kDiagnosisSizeSignals[2].offset, size.std_exponent});
}

bool unpack_diagnosis_size(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[4];
  if (!unpack(can::kDiagnosisSize, message, node, raw)) return false;
  assign(diagnosis.size.value, raw[0]);
  assign(diagnosis.size.std, raw[1]);
  assign(diagnosis.size.exponent, raw[2] + can::kDiagnosisSizeSignals[2].offset);
  assign(diagnosis.size.std_exponent, raw[3]);
  return true;
}

CanFrame pack_diagnosis_rival(int node, const Diagnosis& diagnosis) {
  return can::pack<can::kDiagnosisRival>(node, 0,
                                         {static_cast<int64_t>(diagnosis.rival), diagnosis.rival_place_a,
                                          diagnosis.rival_place_b, diagnosis.rival_quantity, diagnosis.rival_permille});
}

bool unpack_diagnosis_rival(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[5];
  if (!unpack(can::kDiagnosisRival, message, node, raw)) return false;
  assign(diagnosis.rival, raw[0]);
  assign(diagnosis.rival_place_a, raw[1]);
  assign(diagnosis.rival_place_b, raw[2]);
  assign(diagnosis.rival_quantity, raw[3]);
  assign(diagnosis.rival_permille, raw[4]);
  return true;
}

CanFrame pack_parameter(int node, const ParameterDescription& parameter) {
  return can::pack<can::kParameter>(node, 0,
                                    {parameter.index, parameter.count, static_cast<int64_t>(parameter.kind),
                                     parameter.place_a, parameter.place_b, parameter.rotating});
}

bool unpack_parameter(const CanFrame& message, int& node, ParameterDescription& parameter) {
  int64_t raw[6];
  if (!unpack(can::kParameter, message, node, raw)) return false;
  assign(parameter.index, raw[0]);
  assign(parameter.count, raw[1]);
  assign(parameter.kind, raw[2]);
  assign(parameter.place_a, raw[3]);
  assign(parameter.place_b, raw[4]);
  parameter.rotating = raw[5] != 0;
  return true;
}

CanFrame pack_scaling(int node, const ChannelScaling& scaling) {
  return can::pack<can::kScaling>(node, 0,
                                  {scaling.place, static_cast<int64_t>(scaling.quantity), scaling.rotating,
                                   scaling.exponent, scaling.unit_per_code, scaling.delay_us});
}

bool unpack_scaling(const CanFrame& message, int& node, ChannelScaling& scaling) {
  int64_t raw[6];
  if (!unpack(can::kScaling, message, node, raw)) return false;
  assign(scaling.place, raw[0]);
  assign(scaling.quantity, raw[1]);
  scaling.rotating = raw[2] != 0;
  assign(scaling.exponent, raw[3]);
  assign(scaling.unit_per_code, raw[4]);
  assign(scaling.delay_us, raw[5]);
  return true;
}

CanFrame pack_range(int node, const ChannelRange& range) {
  return can::pack<can::kRange>(
      node, 0,
      {range.place, static_cast<int64_t>(range.quantity), range.rotating, range.offset_code, range.full_scale_code});
}

bool unpack_range(const CanFrame& message, int& node, ChannelRange& range) {
  int64_t raw[5];
  if (!unpack(can::kRange, message, node, raw)) return false;
  assign(range.place, raw[0]);
  assign(range.quantity, raw[1]);
  range.rotating = raw[2] != 0;
  assign(range.offset_code, raw[3]);
  assign(range.full_scale_code, raw[4]);
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
