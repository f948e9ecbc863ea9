// See alarm_message.hpp.
#include "firmware/rig_controller/safety/alarm_message.hpp"

namespace firmware {
namespace {

constexpr uint8_t kRegisterGeneric = 1 << 0;
constexpr uint8_t kRegisterCommunication = 1 << 4;
constexpr uint8_t kRegisterManufacturer = 1 << 7;

struct AlarmRow {
  AlarmCause cause;
  EmergencyCode code;
  uint16_t bit;
  uint8_t error_register;
};

constexpr AlarmRow kRows[] = {
    {AlarmCause::kEmergencyStop, EmergencyCode::kEmergencyStop, fault_bit(Fault::kEmergencyStop),
     kRegisterManufacturer},
    {AlarmCause::kSensorSaturated, EmergencyCode::kSensorSaturated, fault_bit(Fault::kSensorSaturated),
     kRegisterManufacturer},
    {AlarmCause::kSensorLost, EmergencyCode::kSensorLost, fault_bit(Fault::kSensorLost), kRegisterManufacturer},
    {AlarmCause::kSensorFault, EmergencyCode::kHardware, fault_bit(Fault::kSensorLost), kRegisterManufacturer},
    {AlarmCause::kDriveLimit, EmergencyCode::kDriveLimit, fault_bit(Fault::kDriveLimit), kRegisterManufacturer},
    {AlarmCause::kResponseLimit, EmergencyCode::kDriveLimit, fault_bit(Fault::kDriveLimit), kRegisterManufacturer},
    {AlarmCause::kStepLate, EmergencyCode::kWatchdog, fault_bit(Fault::kWatchdog), kRegisterManufacturer},
    {AlarmCause::kDriveNotTaken, EmergencyCode::kDriveNotTaken, fault_bit(Fault::kDriveNotTaken),
     kRegisterManufacturer},
    {AlarmCause::kRelayNotTaken, EmergencyCode::kDriveNotTaken, fault_bit(Fault::kDriveNotTaken),
     kRegisterManufacturer},
    {AlarmCause::kWorkerLate, EmergencyCode::kSoftware, fault_bit(Fault::kWatchdog), kRegisterManufacturer},
    {AlarmCause::kConfiguration, EmergencyCode::kConfiguration, fault_bit(Fault::kConfiguration),
     kRegisterManufacturer},
    {AlarmCause::kSamplesMissed, EmergencyCode::kSamplesMissed, fault_bit(Fault::kSamplesMissed), 0},
    {AlarmCause::kNotSettled, EmergencyCode::kNotSettled, 0, 0},
    {AlarmCause::kStore, EmergencyCode::kStore, fault_bit(Fault::kStore), kRegisterManufacturer},
    {AlarmCause::kCanOverflow, EmergencyCode::kCanOverflow, fault_bit(Fault::kCanOverflow), kRegisterCommunication},
    {AlarmCause::kCanErrorPassive, EmergencyCode::kCanErrorPassive, fault_bit(Fault::kCanErrorPassive),
     kRegisterCommunication},
    {AlarmCause::kCanRecovered, EmergencyCode::kCanBusOffRecovered, 0, kRegisterCommunication},
};

const AlarmRow* row_of(AlarmCause cause) {
  for (const AlarmRow& row : kRows)
    if (row.cause == cause) return &row;
  return nullptr;
}

}  // namespace

EmergencyCode emergency_code(AlarmCause cause) {
  const AlarmRow* row = row_of(cause);
  return row ? row->code : EmergencyCode::kNoError;
}

uint16_t status_bit(AlarmCause cause) {
  const AlarmRow* row = row_of(cause);
  return row ? row->bit : uint16_t{0};
}

uint8_t error_register_bit(AlarmCause cause) {
  const AlarmRow* row = row_of(cause);
  return row ? row->error_register : uint8_t{0};
}

Emergency emergency_of(const Alarm& alarm, uint8_t error_register) {
  Emergency emergency;
  emergency.code = emergency_code(alarm.cause);
  emergency.error_register = error_register ? static_cast<uint8_t>(error_register | kRegisterGeneric) : uint8_t{0};
  emergency.detail = alarm.detail;
  if (alarm.node != kNoNode) {
    emergency.place = place_of_node(alarm.node);
    emergency.quantity = alarm.quantity;
  }
  return emergency;
}

void AlarmQueue::push(const Emergency& emergency, bool urgent) {
  for (int i = 0; i < count_; ++i) {
    if (waiting_[i].emergency.code != emergency.code) continue;
    waiting_[i].emergency.detail = emergency.detail;
    if (!urgent) return;
    for (; i > 0; --i) waiting_[i] = waiting_[i - 1];
    waiting_[0] = {emergency, true};
    return;
  }
  if (count_ == kCapacity) return;
  const int place = urgent ? 0 : count_;
  for (int i = count_; i > place; --i) waiting_[i] = waiting_[i - 1];
  waiting_[place] = {emergency, urgent};
  ++count_;
}

bool AlarmQueue::pop(uint64_t now_ns, uint64_t inhibit_ns, Emergency& emergency) {
  if (count_ == 0) return false;
  if (!waiting_[0].urgent && sent_before_ && now_ns - last_ns_ < inhibit_ns) return false;
  emergency = waiting_[0].emergency;
  --count_;
  for (int i = 0; i < count_; ++i) waiting_[i] = waiting_[i + 1];
  sent_before_ = true;
  last_ns_ = now_ns;
  return true;
}

}  // namespace firmware
