// The only description of the CAN frames: packing, the DBC, `host_sim decode` and the tables of docs/can_protocol.md
// all come from here. To add a frame: describe it, append it to kFrames, and write its struct in messages.hpp;
// identifier collisions and overlapping signals do not compile (frame_plan_check.hpp).
//
// Columns of a signal: name, start bit, bits, signed, factor (numerator, denominator), offset, unit, names, comment.
#pragma once
#include "firmware/can_protocol/frame_description.hpp"
#include "firmware/can_protocol/value_tables.hpp"
#include "firmware/configuration/capacity.hpp"

namespace firmware {
namespace can {

template <size_t N>
inline constexpr FrameDescription describe(const char* name, IdPlan ids, Sender sender, uint16_t cycle_ms,
                                           const char* when, uint8_t length, const Signal (&signals)[N],
                                           const char* comment, bool fd = false, uint8_t repeats = 1) {
  return FrameDescription{name,   ids, sender, cycle_ms, when, length, fd, repeats, signals, static_cast<uint8_t>(N),
                          comment};
}

constexpr FrameDescription without_data(const char* name, IdPlan ids, Sender sender, const char* when,
                                        const char* comment) {
  return FrameDescription{name, ids, sender, 0, when, 0, false, 1, nullptr, 0, comment};
}

// ---- To everybody: time
inline constexpr FrameDescription kSync =
    without_data("sync", {0x080, 0}, Sender::kMaster, "when the master likes", "Closes the window on all nodes.");

// ---- Network: who does what, who is there
inline constexpr Signal kNetworkCommandSignals[] = {
    {"command", 0, 8, false, 1, 1, 0, "state", states(kNetworkCommands), "CANopen network command"},
    {"node", 8, 8, false, 1, 1, 0, "node", {}, "which one; 0 all"}};
inline constexpr FrameDescription kNetworkCommand =
    describe("network_command", {0x000, 0}, Sender::kMaster, 0, "when the master likes", 2, kNetworkCommandSignals,
             "Starts or ramps down the excitation programme, forgets a latched fault.");

inline constexpr Signal kHeartbeatSignals[] = {
    {"state", 0, 8, false, 1, 1, 0, "state", states(kHeartbeatStates), "CANopen state; 0 once, at boot-up"}};
inline constexpr FrameDescription kHeartbeat =
    describe("heartbeat", {0x700}, Sender::kController, 100, "100 ms", 1, kHeartbeatSignals,
             "The node is alive. Three missing ones mean that it is not.");

inline constexpr Signal kEmergencySignals[] = {
    {"code", 0, 16, false, 1, 1, 0, "state", states(kEmergencyCodes), "CANopen error code; 0 when the error is gone"},
    {"error_register", 16, 8, false, 1, 1, 0, "flags", flags(kErrorRegister), "object 1001"},
    {"place", 24, 5, false, 1, 1, 0, "DOF", states(kPlaces), "DOF of the channel concerned"},
    {"quantity", 29, 3, false, 1, 1, 0, "state", states(kQuantities), "quantity of the channel concerned"},
    {"detail", 32, 32, false, 1, 1, 0, "1", {}, "how often, or how many; 0 where nothing is counted"}};
inline constexpr FrameDescription kEmergency =
    describe("emergency", {0x080}, Sender::kController, 0, "on the event, 100 ms apart at least", 8, kEmergencySignals,
             "Something happened that needs attention now.");

// ---- State of the controller
inline constexpr Signal kStatusSignals[] = {
    {"faults", 0, 16, false, 1, 1, 0, "flags", flags(kFaults), "present now"},
    {"mode", 16, 4, false, 1, 1, 0, "state", states(kModes), "step of the excitation programme"},
    {"quality", 20, 4, false, 1, 1, 0, "state", states(kQualityStates), "gravest status among the estimates"},
    {"condition_log2", 24, 8, false, 1, 1, 0, "1", {}, "log2 of the condition number, rounded down"},
    {"update_counter", 32, 32, false, 1, 1, 0, "1", {}, "windows closed since start"}};
inline constexpr FrameDescription kStatus =
    describe("status", {0x180}, Sender::kController, 100, "100 ms", 8, kStatusSignals,
             "What the controller does and whether to believe it.");

inline constexpr Signal kHealthSignals[] = {
    {"uptime", 0, 24, false, 1, 1, 0, "s", {}, "since start"},
    {"missed_samples", 24, 16, false, 1, 1, 0, "samples", {}, "gaps in the sample sequence; stays at 65535"},
    {"saturated_samples", 40, 16, false, 1, 1, 0, "samples", {}, "with a channel at full scale; stays at 65535"},
    {"bus_off", 56, 8, false, 1, 1, 0, "times", {}, "bus-off events; stays at 255"}};
inline constexpr FrameDescription kHealth = describe("health", {0x280}, Sender::kController, 1000, "1 s", 8,
                                                     kHealthSignals, "Counters since start, each named by its cause.");

inline constexpr Signal kBusHealthSignals[] = {
    {"restarts", 0, 8, false, 1, 1, 0, "times", {}, "returns from bus-off; stays at 255"},
    {"error_passive", 8, 8, false, 1, 1, 0, "times", {}, "error-passive events; stays at 255"},
    {"controller_overflow", 16, 8, false, 1, 1, 0, "times", {}, "receive overflows; stays at 255"},
    {"interface_down", 24, 8, false, 1, 1, 0, "times", {}, "interface taken down; stays at 255"},
    {"frames_not_sent", 32, 16, false, 1, 1, 0, "frames", {}, "given up, transmit queue full; stays at 65535"},
    {"sensor_frames_lost", 48, 16, false, 1, 1, 0, "frames", {}, "sensor frames that never came; stays at 65535"}};
inline constexpr FrameDescription kBusHealth = describe("bus_health", {0x290}, Sender::kController, 1000, "1 s", 8,
                                                        kBusHealthSignals, "What went wrong on the bus since start.");

inline constexpr Signal kIdentitySignals[] = {
    {"version_major", 0, 8, false, 1, 1, 0, "1", {}, "firmware version"},
    {"version_minor", 8, 8, false, 1, 1, 0, "1", {}, "firmware version"},
    {"version_patch", 16, 8, false, 1, 1, 0, "1", {}, "firmware version"},
    {"parameters", 24, 8, false, 1, 1, 0, "1", {}, "estimates that the node sends per window"},
    {"configuration_crc", 32, 32, false, 1, 1, 0, "hex", {}, "of the configuration in use"}};
inline constexpr FrameDescription kIdentity =
    describe("identity", {0x380}, Sender::kController, 1000, "1 s", 8, kIdentitySignals,
             "Which firmware runs with which configuration.");

// ---- Results
inline constexpr Signal kWindowSignals[] = {
    {"residual", 0, 32, false, 1, 1000000000, 0, "1", {}, "mean normalised residual of the energy equations"},
    {"equations", 32, 16, false, 1, 1, 0, "1", {}, "energy equations used; stays at 65535"},
    {"window", 48, 16, false, 1, 1, 0, "1", {}, "windows closed since start, modulo 65536"}};
inline constexpr FrameDescription kWindow =
    describe("window", {0x390}, Sender::kController, 1000, "each window, before its estimates", 8, kWindowSignals,
             "A window has closed; its estimates follow.");

// Also the record of the CAN FD form.
inline constexpr Signal kEstimateSignals[] = {
    {"value", 0, 32, true, 1, 1, 0, "10^exponent", {}, "times 10^exponent: SI units of the parameter"},
    {"std", 32, 16, false, 1, 1, 0, "10^(e+s)", {}, "times 10^(exponent + std_exponent): same unit"},
    {"exponent", 48, 5, false, 1, 1, -24, "1", {}, "decimal exponent of value"},
    {"status", 53, 3, false, 1, 1, 0, "state", states(kEstimateStates), "whether to believe the number"},
    {"std_exponent", 56, 4, false, 1, 1, 0, "1", {}, "decimal exponent of std above that of value"},
    {"window", 60, 3, false, 1, 1, 0, "1", {}, "windows closed since start, modulo 8"},
    {"untested", 63, 1, false, 1, 1, 0, "state", states(kUntestedStates),
     "with status 7: the data do not contradict the model, they cannot test it"}};
inline constexpr FrameDescription kEstimate =
    describe("estimate", {0x400, 16, kWireUnknowns, 16, {0, 0x80, 0x100}}, Sender::kController, 1000,
             "each window, 50 ms to 1 s", 8, kEstimateSignals,
             "One estimated parameter; its name is in the frame `parameter` of the same index.");
inline constexpr FrameDescription kEstimateFd =
    describe("estimates_fd", {0x2C0, 8, kWireUnknowns / 8}, Sender::kController, 1000,
             "each window, in place of `estimate`, on a CAN FD bus", 64, kEstimateSignals,
             "Eight estimates in one frame: frame j holds those of index 8j to 8j + 7.", true, 8);

// The same estimates once more, for tools that plot numbers and know no decimal exponents. Integers here; a DBC for a
// rig declares them as floats. Also the record of the CAN FD form.
inline constexpr Signal kEstimateFloatSignals[] = {
    {"value_bits", 0, 32, false, 1, 1, 0, "hex", {}, "value in SI units as IEEE 754 single precision"},
    {"std_bits", 32, 32, false, 1, 1, 0, "hex", {}, "standard deviation, likewise"}};
inline constexpr FrameDescription kEstimateFloat =
    describe("estimate_float", {0x580, 16, kWireUnknowns, 16, {0, 0x80, 0x180}}, Sender::kController, 1000,
             "each window, behind everything else, where the load allows", 8, kEstimateFloatSignals,
             "The estimate of the same index as two 32-bit floats; not a number where nothing was estimated.");
inline constexpr FrameDescription kEstimateFloatFd =
    describe("estimates_float_fd", {0x330, 8, kWireUnknowns / 8}, Sender::kController, 1000,
             "each window, in place of `estimate_float`, on a CAN FD bus", 64, kEstimateFloatSignals,
             "Eight estimates as floats in one frame: frame j holds those of index 8j to 8j + 7.", true, 8);

inline constexpr Signal kDiagnosisSignals[] = {
    {"cause", 0, 8, false, 1, 1, 0, "state", states(kCauses),
     "effect that explains the energy residual; UNKNOWN: something is missing, and none of the effects explains it"},
    {"place_a", 8, 8, false, 1, 1, 0, "DOF", states(kPlaces), "DOF, or first end of the link"},
    {"place_b", 16, 8, false, 1, 1, 0, "DOF", states(kPlaces), "second end of the link; NONE for a DOF or a channel"},
    {"quantity", 24, 8, false, 1, 1, 0, "state", states(kQuantities),
     "of the channel, where the cause is in the measurement"},
    {"unexplained", 32, 16, false, 1, 10, 0, "%", {}, "part of the damping energy that the model leaves unexplained"},
    {"gained",
     48,
     16,
     false,
     1,
     10,
     0,
     "%",
     {},
     "part of what stands out along the nearest cause's force, beyond noise, that it takes away"}};
inline constexpr FrameDescription kDiagnosis =
    describe("diagnosis", {0x480}, Sender::kController, 1000, "on change and 1 s", 8, kDiagnosisSignals,
             "What the model of the rig lacks, as far as running sums tell.");

inline constexpr Signal kDiagnosisSizeSignals[] = {
    {"value", 0, 32, true, 1, 1, 0, "10^exponent", {}, "times 10^exponent: size of the cause, SI units of its effect"},
    {"std", 32, 16, false, 1, 1, 0, "10^(e+s)", {}, "times 10^(exponent + std_exponent): same unit"},
    {"exponent", 48, 5, false, 1, 1, -24, "1", {}, "decimal exponent of value"},
    {"std_exponent", 56, 4, false, 1, 1, 0, "1", {}, "decimal exponent of std above that of value"},
    {"corrected", 60, 1, false, 1, 1, 0, "state", states(kCorrectedStates),
     "the channel's fault is taken out of the samples behind the estimates"}};
inline constexpr FrameDescription kDiagnosisSize =
    describe("diagnosis_size", {0x3A0}, Sender::kController, 1000, "after each diagnosis that names a cause", 8,
             kDiagnosisSizeSignals,
             "How large the named cause is: N/m^3 for a cubic stiffness, s for a delay. Of the nearest one where the "
             "cause is UNKNOWN.");

inline constexpr Signal kDiagnosisRivalSignals[] = {
    {"cause", 0, 8, false, 1, 1, 0, "state", states(kCauses), "effect that explains the residual next best"},
    {"place_a", 8, 8, false, 1, 1, 0, "DOF", states(kPlaces), "DOF, or first end of the link"},
    {"place_b", 16, 8, false, 1, 1, 0, "DOF", states(kPlaces), "second end of the link; NONE for a DOF or a channel"},
    {"quantity", 24, 8, false, 1, 1, 0, "state", states(kQuantities),
     "of the channel, where the cause is in the measurement"},
    {"likelihood", 32, 16, false, 1, 10, 0, "%", {}, "gain in log-likelihood, as a part of the named cause's"}};
inline constexpr FrameDescription kDiagnosisRival =
    describe("diagnosis_rival", {0x3B0}, Sender::kController, 1000, "after each diagnosis that names a cause", 6,
             kDiagnosisRivalSignals,
             "The cause that comes nearest to the named one; where that is UNKNOWN, the nearest of all.");

// ---- What makes a log self-describing
inline constexpr Signal kParameterSignals[] = {
    {"index", 0, 8, false, 1, 1, 0, "1", {}, "of the estimate that is described"},
    {"count", 8, 8, false, 1, 1, 0, "1", {}, "parameters of this node"},
    {"kind", 16, 8, false, 1, 1, 0, "state", states(kParameterKinds), "term of the energy equation"},
    {"place_a", 24, 8, false, 1, 1, 0, "DOF", states(kPlaces), "DOF, or first end of the link"},
    {"place_b", 32, 8, false, 1, 1, 0, "DOF", states(kPlaces), "second end of the link; NONE for a mass"},
    {"motion", 40, 8, false, 1, 1, 0, "state", states(kMotions), "tells N s/m from N m s/rad"}};
inline constexpr FrameDescription kParameter =
    describe("parameter", {0x680}, Sender::kController, 1000, "each parameter at start and 1 s", 6, kParameterSignals,
             "Names the estimate of the same index: viscous[1-2].");

inline constexpr Signal kScalingSignals[] = {
    {"place", 0, 5, false, 1, 1, 0, "DOF", states(kPlaces), "DOF of the channel"},
    {"quantity", 5, 2, false, 1, 1, 0, "state", states(kChannelQuantities), "quantity of the channel"},
    {"motion", 7, 1, false, 1, 1, 0, "state", states(kMotions), "tells m from rad"},
    {"exponent", 8, 8, true, 1, 1, 0, "1", {}, "decimal exponent of unit_per_code"},
    {"unit_per_code", 16, 32, true, 1, 1, 0, "10^exponent", {}, "SI units per code = unit_per_code * 10^exponent"},
    {"delay", 48, 16, true, 1, 1, 0, "us", {}, "how late the channel is; removed by the controller"}};
inline constexpr FrameDescription kScaling =
    describe("scaling", {0x690}, Sender::kController, 5000, "each channel at start and 5 s", 8, kScalingSignals,
             "SI value of a channel = (code - offset) * unit_per_code.");

inline constexpr Signal kRangeSignals[] = {
    {"place", 0, 5, false, 1, 1, 0, "DOF", states(kPlaces), "DOF of the channel"},
    {"quantity", 5, 2, false, 1, 1, 0, "state", states(kChannelQuantities), "quantity of the channel"},
    {"motion", 7, 1, false, 1, 1, 0, "state", states(kMotions), "tells m from rad"},
    {"offset", 8, 24, true, 1, 1, 0, "codes", {}, "code of the SI value 0"},
    {"full_scale", 32, 24, false, 1, 1, 0, "codes", {}, "a code of this size or more is a saturated sensor"}};
inline constexpr FrameDescription kRange =
    describe("range", {0x6A0}, Sender::kController, 5000, "each channel at start and 5 s", 7, kRangeSignals,
             "Offset and full scale of a channel, in codes.");

// ---- Sensors to controller: member 0 is DOF 1, member 16 the moving base
inline constexpr Signal kSensorMotion16Signals[] = {
    {"sequence", 0, 16, false, 1, 1, 0, "samples", {}, "number of the sample, modulo 65536"},
    {"displacement", 16, 16, true, 1, 1, 0, "codes", {}, "raw code"},
    {"velocity", 32, 16, true, 1, 1, 0, "codes", {}, "raw code"},
    {"acceleration", 48, 16, true, 1, 1, 0, "codes", {}, "raw code"}};
inline constexpr FrameDescription kSensorMotion16 =
    describe("sensor_motion_16", {0x1A1, 0, kWireNodes}, Sender::kSensor, 1, "each sample", 8, kSensorMotion16Signals,
             "16-bit motion of a DOF, the whole of it in one frame.");

inline constexpr Signal kSensorMotion24Signals[] = {
    {"sequence", 0, 16, false, 1, 1, 0, "samples", {}, "number of the sample, modulo 65536"},
    {"displacement", 16, 24, true, 1, 1, 0, "codes", {}, "raw code"},
    {"velocity", 40, 24, true, 1, 1, 0, "codes", {}, "raw code"}};
inline constexpr FrameDescription kSensorMotion24 =
    describe("sensor_motion_24", {0x1C1, 0, kWireNodes}, Sender::kSensor, 1, "each sample", 8, kSensorMotion24Signals,
             "24-bit motion of a DOF.");

inline constexpr Signal kSensorForce24Signals[] = {
    {"sequence", 0, 16, false, 1, 1, 0, "samples", {}, "number of the sample, modulo 65536"},
    {"force", 16, 24, true, 1, 1, 0, "codes", {}, "raw code"},
    {"acceleration", 40, 24, true, 1, 1, 0, "codes", {}, "raw code"}};
inline constexpr FrameDescription kSensorForce24 =
    describe("sensor_force_24", {0x1E1, 0, kWireNodes}, Sender::kSensor, 1, "each sample", 8, kSensorForce24Signals,
             "24-bit force and acceleration of a DOF.");

inline constexpr Signal kSensorPair24Signals[] = {
    {"sequence", 0, 16, false, 1, 1, 0, "samples", {}, "number of the sample, modulo 65536"},
    {"first", 16, 24, true, 1, 1, 0, "codes", {}, "raw code of the rig's channel number 2 d - 1"},
    {"second", 40, 24, true, 1, 1, 0, "codes", {}, "raw code of the rig's channel number 2 d; 0 where there is none"}};
inline constexpr FrameDescription kSensorPair24 =
    describe("sensor_pair_24", {0x261, 0, kWireNodes}, Sender::kSensor, 1, "each sample", 8, kSensorPair24Signals,
             "Two channels of the rig, whichever DOFs they are of: channels are numbered by DOF, then quantity.");

inline constexpr Signal kSensorForceSignals[] = {
    {"sequence", 0, 16, false, 1, 1, 0, "samples", {}, "number of the sample, modulo 65536"},
    {"force", 16, 24, true, 1, 1, 0, "codes", {}, "raw code"}};
inline constexpr FrameDescription kSensorForce =
    describe("sensor_force", {0x221, 0, kWireDofs}, Sender::kSensor, 1, "each sample", 5, kSensorForceSignals,
             "Force of a driven DOF, beside `sensor_motion_16`.");

inline constexpr Signal kSensorFdSignals[] = {
    {"sequence", 0, 32, false, 1, 1, 0, "samples", {}, "number of the sample"},
    {"force", 32, 24, true, 1, 1, 0, "codes", {}, "raw code"},
    {"displacement", 56, 24, true, 1, 1, 0, "codes", {}, "raw code"},
    {"velocity", 80, 24, true, 1, 1, 0, "codes", {}, "raw code"},
    {"acceleration", 104, 24, true, 1, 1, 0, "codes", {}, "raw code"}};
inline constexpr FrameDescription kSensorFd =
    describe("sensor_fd", {0x241, 0, kWireNodes}, Sender::kSensor, 1, "each sample", 16, kSensorFdSignals,
             "All channels of a DOF in one CAN FD frame.", true);

// ---- Controller to the shaker amplifier
inline constexpr Signal kDriveSignals[] = {
    {"drive", 0, 32, true, 25, 536870912, 0, "%", {}, "signed part of full scale: a 2^31-th per count"},
    {"sequence", 32, 16, false, 1, 1, 0, "samples", {}, "sample that the command answers, modulo 65536"},
    {"state", 48, 8, false, 1, 1, 0, "state", states(kDriveStates), "anything but ENABLED: hold the shaker still"}};
inline constexpr FrameDescription kDrive =
    describe("drive", {0x200}, Sender::kController, 1, "each sample", 7, kDriveSignals,
             "Command to the shaker amplifier; without a new one for 10 ms it must go to zero.");

// ---- Settings
inline constexpr Signal kSdoSignals[] = {
    {"command", 0, 8, false, 1, 1, 0, "state", states(kSdoCommands), "CANopen SDO command specifier"},
    {"object", 8, 16, false, 1, 1, 0, "state", states(kSdoObjects), "index in the object dictionary"},
    {"subindex", 24, 8, false, 1, 1, 0, "1", {}, "subindex in the object dictionary"},
    {"data", 32, 32, false, 1, 1, 0, "hex", {}, "value, or abort code"}};
inline constexpr FrameDescription kSdoRequest = describe("sdo_request", {0x600}, Sender::kMaster, 0, "on request", 8,
                                                         kSdoSignals, "Reads or writes an object of the node.");
inline constexpr FrameDescription kSdoReply = describe("sdo_reply", {0x580}, Sender::kController, 0,
                                                       "answers each request", 8, kSdoSignals, "Answer of the node.");

// In rising order of identifiers, so of falling priority on the bus.
inline constexpr const FrameDescription* kFrames[] = {
    &kNetworkCommand, &kSync,       &kEmergency,       &kStatus,   &kSensorMotion16, &kSensorMotion24,
    &kSensorForce24,  &kDrive,      &kSensorForce,     &kSensorFd, &kSensorPair24,   &kHealth,
    &kBusHealth,      &kEstimateFd, &kEstimateFloatFd, &kIdentity, &kWindow,         &kDiagnosisSize,
    &kDiagnosisRival, &kEstimate,   &kDiagnosis,       &kSdoReply, &kEstimateFloat,  &kSdoRequest,
    &kParameter,      &kScaling,    &kRange,           &kHeartbeat};

}  // namespace can
}  // namespace firmware
