// The object dictionary of the node and the configuration store behind it. What can be changed over the bus is the
// heartbeat time; "save" keeps it over a restart, "load" goes back to the settings given at start (and keeps those).
#include "firmware/can_protocol/packing.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
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

SdoAbort RigController::read(uint16_t index, uint8_t subindex, uint8_t (&bytes)[kLongestObject], uint8_t& size) {
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

SdoAbort RigController::write(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size) {
  switch (index) {
    case 0x1010:
    case 0x1011:
      if (subindex != 1) return subindex == 0 ? SdoAbort::kReadOnly : SdoAbort::kNoSubindex;
      if (size != 0 && size != 4) return SdoAbort::kLength;
      if (value != (index == 0x1010 ? kSaveSignature : kLoadSignature)) return SdoAbort::kNotStored;
      if (safe_.live() || settings_.busy()) return SdoAbort::kDeviceState;
      if (index == 0x1011) {
        configuration_.node = default_node_;
        apply_node_settings();
      }
      return begin_save();
    case 0x1017:
      if (subindex != 0) return SdoAbort::kNoSubindex;
      if (size != 0 && size != 2) return SdoAbort::kLength;
      if ((value != 0 && value < kShortestHeartbeat_ms) || value > kLongestHeartbeat_ms) return SdoAbort::kValue;
      configuration_.node.heartbeat_ms = static_cast<uint16_t>(value);
      heartbeat_.change_period(now_ns_, uint64_t{configuration_.node.heartbeat_ms} * 1000000);
      configuration_crc_ = firmware::configuration_crc(configuration_);
      return SdoAbort::kNone;
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

void RigController::apply_node_settings() {
  heartbeat_.start(now_ns_ + uint64_t{configuration_.node.heartbeat_ms} * 1000000,
                   uint64_t{configuration_.node.heartbeat_ms} * 1000000);
  status_.start(now_ns_, uint64_t{configuration_.node.status_ms} * 1000000);
  configuration_crc_ = firmware::configuration_crc(configuration_);
}

// The answer to the request comes once the store is done: a memory card may take seconds, and no step waits for it.
SdoAbort RigController::begin_save() {
  settings_.begin(configuration_);
  const SettingsStore::Outcome outcome = settings_.take_outcome();  // none yet where a worker saves
  return outcome == SettingsStore::Outcome::kNone ? SdoAbort::kPending : end_save(outcome);
}

void RigController::check_save() {
  const SettingsStore::Outcome outcome = settings_.take_outcome();
  if (outcome != SettingsStore::Outcome::kNone) queue_.push(sdo_.complete(end_save(outcome)), false);
}

SdoAbort RigController::end_save(SettingsStore::Outcome outcome) {
  if (outcome == SettingsStore::Outcome::kSaved) return SdoAbort::kNone;
  handle({AlarmCause::kStore});
  return SdoAbort::kNotStored;
}

void RigController::load_from_store() {
  NodeConfiguration stored = configuration_.node;
  if (!settings_.load(configuration_, stored)) return handle({AlarmCause::kStore});
  configuration_.node.heartbeat_ms = stored.heartbeat_ms;
}

}  // namespace firmware
