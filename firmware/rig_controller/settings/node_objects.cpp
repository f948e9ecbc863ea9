// See node_objects.hpp.
#include "firmware/rig_controller/settings/node_objects.hpp"

#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/rig_controller/safety/alarm_message.hpp"
#include "firmware/version.hpp"

namespace firmware {
namespace {

constexpr uint32_t kSaveSignature = 0x65766173;  // "save"
constexpr uint32_t kLoadSignature = 0x64616F6C;  // "load"
constexpr uint32_t kShortestHeartbeat_ms = 10;   // 0: none
constexpr uint32_t kLongestHeartbeat_ms = 0xFFFF;
constexpr uint32_t kDeviceType = 0;  // CiA 301: follows no device profile
constexpr uint32_t kVersionWord = uint32_t{kVersionMajor} << 16 | kVersionMinor;
constexpr char kDeviceName[] = "rig_controller";
constexpr char kHardwareVersion[] = "any";

class Answer {
 public:
  Answer(uint8_t* bytes, uint8_t& size) : bytes_(bytes), size_(size) {}
  SdoAbort number(uint32_t value, uint8_t size) {
    for (int i = 0; i < size; ++i) bytes_[i] = static_cast<uint8_t>(value >> (8 * i));
    size_ = size;
    return SdoAbort::kNone;
  }
  SdoAbort text(const char* text) {
    size_ = 0;
    while (size_ < ObjectDictionary::kLongestObject && text[size_] != '\0') {
      bytes_[size_] = static_cast<uint8_t>(text[size_]);
      ++size_;
    }
    return SdoAbort::kNone;
  }

 private:
  uint8_t* bytes_;
  uint8_t& size_;
};

}  // namespace

NodeObjects::NodeObjects(ControllerConfiguration& configuration, NodeSchedule& schedule, const SafeState& safe,
                         const BusMonitor& bus, hal::ConfigurationStore& store, hal::Worker* store_worker)
    : configuration_(configuration),
      default_node_(configuration.node),
      schedule_(schedule),
      safe_(safe),
      bus_(bus),
      settings_(store, store_worker) {}

SdoAbort NodeObjects::read(uint16_t index, uint8_t subindex, uint8_t (&bytes)[kLongestObject], uint8_t& size) {
  Answer answer(bytes, size);
  const NodeConfiguration& node = configuration_.node;
  if (index == 0x1018) {
    const uint32_t words[] = {4, 0, 0, kVersionWord, configuration_crc_};
    if (subindex > 4) return SdoAbort::kNoSubindex;
    return answer.number(words[subindex], subindex == 0 ? 1 : 4);
  }
  if (index == 0x1010 || index == 0x1011) {
    if (subindex > 1) return SdoAbort::kNoSubindex;
    return answer.number(1, subindex == 0 ? 1 : 4);  // one subindex; it can be saved (loaded) on command
  }
  SdoAbort result = SdoAbort::kNone;
  switch (index) {
    case 0x1000:
      result = answer.number(kDeviceType, 4);
      break;
    case 0x1001:
      result = answer.number(error_register(), 1);
      break;
    case 0x1005:
      result = answer.number(can::frame_id(can::kSync.ids, node.node), 4);
      break;
    case 0x1008:
      result = answer.text(kDeviceName);
      break;
    case 0x1009:
      result = answer.text(kHardwareVersion);
      break;
    case 0x100A:
      result = answer.text(kVersionText);
      break;
    case 0x1014:
      result = answer.number(can::frame_id(can::kEmergency.ids, node.node), 4);
      break;
    case 0x1017:
      result = answer.number(node.heartbeat_ms, 2);
      break;
    default:
      return SdoAbort::kNoObject;
  }
  return subindex == 0 ? result : SdoAbort::kNoSubindex;
}

SdoAbort NodeObjects::write(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size) {
  switch (index) {
    case 0x1010:
    case 0x1011:
      return store(index, subindex, value, size);
    case 0x1017:
      return change_heartbeat(subindex, value, size);
    case 0x1000:
    case 0x1001:
    case 0x1005:
    case 0x1008:
    case 0x1009:
    case 0x100A:
    case 0x1014:
    case 0x1018:
      return SdoAbort::kReadOnly;
    default:
      return SdoAbort::kNoObject;
  }
}

SdoAbort NodeObjects::store(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size) {
  if (subindex != 1) return subindex == 0 ? SdoAbort::kReadOnly : SdoAbort::kNoSubindex;
  if (size != 0 && size != 4) return SdoAbort::kLength;
  if (value != (index == 0x1010 ? kSaveSignature : kLoadSignature)) return SdoAbort::kNotStored;
  if (safe_.live() || settings_.busy()) return SdoAbort::kDeviceState;
  if (index == 0x1011) {
    configuration_.node = default_node_;
    apply();
  }
  return begin_save();
}

SdoAbort NodeObjects::change_heartbeat(uint8_t subindex, uint32_t value, uint8_t size) {
  if (subindex != 0) return SdoAbort::kNoSubindex;
  if (size != 0 && size != 2) return SdoAbort::kLength;
  if ((value != 0 && value < kShortestHeartbeat_ms) || value > kLongestHeartbeat_ms) return SdoAbort::kValue;
  configuration_.node.heartbeat_ms = static_cast<uint16_t>(value);
  schedule_.change_heartbeat(configuration_.node.heartbeat_ms, now_ns_);
  configuration_crc_ = firmware::configuration_crc(configuration_);
  return SdoAbort::kNone;
}

void NodeObjects::apply() {
  schedule_.apply(configuration_.node.heartbeat_ms, configuration_.node.status_ms, now_ns_);
  configuration_crc_ = firmware::configuration_crc(configuration_);
}

// The answer to the request comes once the store is done: a memory card may take seconds, and no step waits for it.
SdoAbort NodeObjects::begin_save() {
  settings_.begin(configuration_);
  const SettingsStore::Outcome outcome = settings_.take_outcome();  // none yet where a worker saves
  return outcome == SettingsStore::Outcome::kNone ? SdoAbort::kPending : end_save(outcome);
}

bool NodeObjects::take_saved(SdoAbort& answer) {
  const SettingsStore::Outcome outcome = settings_.take_outcome();
  if (outcome == SettingsStore::Outcome::kNone) return false;
  answer = end_save(outcome);
  return true;
}

SdoAbort NodeObjects::end_save(SettingsStore::Outcome outcome) {
  if (outcome == SettingsStore::Outcome::kSaved) return SdoAbort::kNone;
  alarm_ = {AlarmCause::kStore};
  return SdoAbort::kNotStored;
}

Alarm NodeObjects::take_alarm() {
  const Alarm alarm = alarm_;
  alarm_ = Alarm{};
  return alarm;
}

Alarm NodeObjects::load() {
  NodeConfiguration stored = configuration_.node;
  const bool readable = settings_.load(configuration_, stored);
  if (readable) configuration_.node.heartbeat_ms = stored.heartbeat_ms;
  configuration_crc_ = firmware::configuration_crc(configuration_);
  return readable ? Alarm{} : Alarm{AlarmCause::kStore};
}

uint8_t NodeObjects::error_register() const {
  uint32_t bits = error_register_bit(safe_.latched().cause);
  if (bus_.state() != BusState::kGood) bits |= error_register_bit(AlarmCause::kCanErrorPassive);
  if (settings_.damaged()) bits |= error_register_bit(AlarmCause::kStore);
  return static_cast<uint8_t>(bits != 0 ? bits | 1 : 0);
}

}  // namespace firmware
