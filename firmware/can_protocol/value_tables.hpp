// The names behind the numbers: every state that travels on the bus. Used by the DBC, by decode and by the protocol
// page.
#pragma once
#include "firmware/can_protocol/frame_description.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {
namespace can {

inline constexpr NamedValue kHeartbeatStates[] = {
    {0, "BOOT_UP"}, {4, "STOPPED"}, {5, "OPERATIONAL"}, {127, "PRE_OPERATIONAL"}};

// Order and numbers of firmware::EstimateStatus. An estimate's frame has three bits for it:
// UNTESTED is 7 there, with a bit of its own.
inline constexpr NamedValue kEstimateStates[] = {{0, "VALID"},     {1, "STALE"},           {2, "BIAS_SUSPECT"},
                                                 {3, "SKEWED"},    {4, "ILL_CONDITIONED"}, {5, "NO_EXCITATION"},
                                                 {6, "SATURATED"}, {7, "MODEL_SUSPECT"}};
inline constexpr NamedValue kQualityStates[] = {{0, "VALID"},     {1, "STALE"},           {2, "BIAS_SUSPECT"},
                                                {3, "SKEWED"},    {4, "ILL_CONDITIONED"}, {5, "NO_EXCITATION"},
                                                {6, "SATURATED"}, {7, "MODEL_SUSPECT"},   {8, "UNTESTED"}};
inline constexpr NamedValue kUntestedStates[] = {{0, "no"}, {1, "UNTESTED"}};

// Order and numbers of firmware::ControllerMode.
inline constexpr NamedValue kModes[] = {{0, "INITIALISING"}, {1, "IDLE"},           {2, "RAMP"},
                                        {3, "SETTLE"},       {4, "INTEGRATE"},      {5, "FREE_DECAY"},
                                        {6, "DONE"},         {7, "EMERGENCY_STOP"}, {8, "FAULT"}};

// Order and numbers of firmware::Fault: bit numbers.
inline constexpr NamedValue kFaults[] = {
    {0, "EMERGENCY_STOP"},    {1, "SENSOR_SATURATED"}, {2, "SENSOR_LOST"},
    {3, "SAMPLES_MISSED"},    {4, "DRIVE_LIMIT"},      {5, "WATCHDOG"},
    {6, "CAN_ERROR_PASSIVE"}, {7, "CAN_BUS_OFF"},      {8, "CAN_OVERFLOW"},
    {9, "CONFIGURATION"},     {10, "STORE"},           {11, "ACCUMULATOR_SATURATED"},
    {12, "DRIVE_NOT_TAKEN"}};

inline constexpr NamedValue kEmergencyCodes[] = {{0x0000, "NO_ERROR"},
                                                 {0x1000, "GENERIC"},
                                                 {0x5000, "HARDWARE"},
                                                 {0x6000, "SOFTWARE"},
                                                 {0x6100, "WATCHDOG"},
                                                 {0x6300, "CONFIGURATION"},
                                                 {0x6310, "STORE"},
                                                 {0x8110, "CAN_OVERFLOW"},
                                                 {0x8120, "CAN_ERROR_PASSIVE"},
                                                 {0x8140, "CAN_BUS_OFF_RECOVERED"},
                                                 {0x8700, "SYNC_LOST"},
                                                 {0xFF01, "EMERGENCY_STOP"},
                                                 {0xFF02, "SENSOR_SATURATED"},
                                                 {0xFF03, "SENSOR_LOST"},
                                                 {0xFF04, "SAMPLES_MISSED"},
                                                 {0xFF05, "DRIVE_LIMIT"},
                                                 {0xFF06, "DRIVE_NOT_TAKEN"},
                                                 {0xFF07, "NOT_SETTLED"}};

inline constexpr NamedValue kNetworkCommands[] = {{1, "START"}, {2, "STOP"}, {129, "RESET"}};

inline constexpr NamedValue kErrorRegister[] = {{0, "GENERIC"},     {1, "CURRENT"},       {2, "VOLTAGE"},
                                                {3, "TEMPERATURE"}, {4, "COMMUNICATION"}, {5, "DEVICE_PROFILE"},
                                                {7, "MANUFACTURER"}};

inline constexpr NamedValue kQuantities[] = {
    {0, "force"}, {1, "displacement"}, {2, "velocity"}, {3, "acceleration"}, {7, "NONE"}};
// In two bits, where there is always a channel.
inline constexpr NamedValue kChannelQuantities[] = {
    {0, "force"}, {1, "displacement"}, {2, "velocity"}, {3, "acceleration"}};
inline constexpr NamedValue kCorrectedStates[] = {{0, "no"}, {1, "CORRECTED"}};
inline constexpr NamedValue kMotions[] = {{0, "TRANSLATION"}, {1, "ROTATION"}};

// A DOF stands for itself by its number from 1.
constexpr int kPlaceGround = 0;
constexpr int kPlaceBase = 17;
constexpr int kPlaceNone = 31;
inline constexpr NamedValue kPlaces[] = {{kPlaceGround, "GROUND"}, {kPlaceBase, "BASE"}, {kPlaceNone, "NONE"}};

// From the vocabulary: the kinds of parameters by firmware::TermKind, the causes by the CAN number of their rows.
template <int N>
struct NamedValues {
  NamedValue at[N] = {};
};
constexpr NamedValues<kTermKinds> parameter_kinds() {
  NamedValues<kTermKinds> names;
  for (int t = 0; t < kTermKinds; ++t) names.at[t] = {t, row_of(static_cast<TermKind>(t)).word.text};
  return names;
}
constexpr int count_causes() {
  int count = 0;
  for (const EffectRow& row : kEffectTable) count += row.can.number != 0 ? 1 : 0;
  return count;
}
constexpr int kOtherCauses = 5;  // of firmware::Cause
constexpr NamedValues<count_causes() + kOtherCauses> causes() {
  NamedValues<count_causes() + kOtherCauses> names;
  names.at[0] = {0, "NONE"};
  int next = 1;
  for (int number = 1; number < 252; ++number)
    for (const EffectRow& row : kEffectTable)
      if (row.can.number == number) names.at[next++] = {number, row.word.text};
  names.at[next++] = {252, "polarity"};
  names.at[next++] = {253, "unit"};
  names.at[next++] = {254, "AMBIGUOUS"};
  names.at[next++] = {255, "UNKNOWN"};
  return names;
}
inline constexpr NamedValues<kTermKinds> kParameterKindNames = parameter_kinds();
inline constexpr NamedValues<count_causes() + kOtherCauses> kCauseNames = causes();
inline constexpr const NamedValue (&kParameterKinds)[kTermKinds] = kParameterKindNames.at;
inline constexpr const NamedValue (&kCauses)[count_causes() + kOtherCauses] = kCauseNames.at;

inline constexpr NamedValue kDriveStates[] = {{0, "OFF"}, {1, "ENABLED"}, {2, "STOPPED"}};

inline constexpr NamedValue kSdoCommands[] = {
    {0x23, "WRITE_4_BYTES"}, {0x27, "WRITE_3_BYTES"},   {0x2B, "WRITE_2_BYTES"}, {0x2F, "WRITE_1_BYTE"},
    {0x40, "READ"},          {0x60, "WRITTEN_OR_NEXT"}, {0x70, "NEXT_TOGGLED"},  {0x41, "STRING_FOLLOWS"},
    {0x43, "VALUE_4_BYTES"}, {0x47, "VALUE_3_BYTES"},   {0x4B, "VALUE_2_BYTES"}, {0x4F, "VALUE_1_BYTE"},
    {0x80, "ABORT"}};

inline constexpr NamedValue kSdoObjects[] = {
    {0x1000, "device_type"},      {0x1001, "error_register"},   {0x1005, "sync_id"}, {0x1008, "device_name"},
    {0x1009, "hardware_version"}, {0x100A, "firmware_version"}, {0x1010, "save"},    {0x1011, "load_defaults"},
    {0x1014, "emergency_id"},     {0x1017, "heartbeat_time"},   {0x1018, "identity"}};

}  // namespace can
}  // namespace firmware
