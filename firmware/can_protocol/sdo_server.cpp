#include "firmware/can_protocol/sdo_server.hpp"

#include "firmware/can_protocol/packing.hpp"

namespace firmware {
namespace {

// Abort codes of CiA 301.
constexpr uint32_t kToggleNotAlternated = 0x05030000;
constexpr uint32_t kUnknownCommand = 0x05040001;
constexpr uint32_t kReadOnly = 0x06010002;
constexpr uint32_t kNoSuchObject = 0x06020000;
constexpr uint32_t kHardwareError = 0x06060000;
constexpr uint32_t kWrongLength = 0x06070010;
constexpr uint32_t kNoSuchSubindex = 0x06090011;
constexpr uint32_t kValueTooLow = 0x06090032;
constexpr uint32_t kCannotStore = 0x08000020;  // also: a wrong signature
constexpr uint32_t kNotInThisState = 0x08000022;

constexpr uint32_t kSignatureSave = 0x65766173;  // "save"
constexpr uint32_t kSignatureLoad = 0x64616F6C;  // "load"
constexpr uint8_t kWritten = 0x60, kAborted = 0x80, kStringFollows = 0x41;
constexpr int kSegmentBytes = 7;

int length_of(const char* text) {
  int length = 0;
  while (text[length] != '\0') ++length;
  return length;
}

// Command specifier of an expedited transfer of 1 to 4 bytes.
uint8_t expedited(uint8_t base, int bytes) { return static_cast<uint8_t>(base | ((4 - bytes) << 2) | 3); }

}  // namespace

struct SdoServer::Object {
  int bytes = 0;  // of a number
  uint32_t value = 0;
  const char* text = nullptr;  // of a string
  bool writable = false;
};

uint32_t SdoServer::find(uint16_t index, uint8_t subindex, Object& object) const {
  const uint32_t identity[] = {4, values_.vendor_id, values_.product_code, values_.revision, values_.serial_number};
  const uint32_t sync_id = can::frame_id(can::kSync.ids, 0), emergency_id = can::frame_id(can::kEmergency.ids, node_);
  uint8_t last_subindex = 0;
  switch (index) {
    case 0x1000:
      object = {4, values_.device_type, nullptr, false};
      break;
    case 0x1001:
      object = {1, values_.error_register, nullptr, false};
      break;
    case 0x1005:
      object = {4, sync_id, nullptr, false};
      break;
    case 0x1008:
      object = {0, 0, values_.device_name, false};
      break;
    case 0x1009:
      object = {0, 0, values_.hardware_version, false};
      break;
    case 0x100A:
      object = {0, 0, values_.firmware_version, false};
      break;
    case 0x1010:
    case 0x1011:
      last_subindex = 1;
      object = {subindex == 0 ? 1 : 4, 1, nullptr, subindex != 0};
      break;
    case 0x1014:
      object = {4, emergency_id, nullptr, false};
      break;
    case 0x1017:
      object = {2, values_.heartbeat_ms, nullptr, true};
      break;
    case 0x1018:
      last_subindex = 4;
      if (subindex <= last_subindex) object = {subindex == 0 ? 1 : 4, identity[subindex], nullptr, false};
      break;
    default:
      return kNoSuchObject;
  }
  return subindex > last_subindex ? kNoSuchSubindex : 0;
}

CanMessage SdoServer::reply(uint8_t command, const Request& to, uint32_t data) const {
  return can::pack<can::kSdoReply>(node_, 0, {command, to.index, to.subindex, data});
}

CanMessage SdoServer::abort(const Request& to, uint32_t code) {
  segments_ = nullptr;
  return reply(kAborted, to, code);
}

CanMessage SdoServer::read(const Request& request) {
  Object object;
  const uint32_t fault = find(request.index, request.subindex, object);
  if (fault != 0) return abort(request, fault);
  if (object.text == nullptr) return reply(expedited(0x40, object.bytes), request, object.value);
  const int length = length_of(object.text);
  if (length >= 1 && length <= 4) {
    uint32_t data = 0;
    for (int i = 0; i < length; ++i) data |= static_cast<uint32_t>(static_cast<uint8_t>(object.text[i])) << (8 * i);
    return reply(expedited(0x40, length), request, data);
  }
  segments_ = object.text;
  transfer_ = request;
  toggle_ = false;
  return reply(kStringFollows, request, static_cast<uint32_t>(length));
}

// Seven bytes of the string: command = toggle, number of unused bytes, and whether this was the last segment.
CanMessage SdoServer::next_segment(const Request& request) {
  const bool toggle = (request.command & 0x10) != 0;
  if (segments_ == nullptr) return abort(request, kUnknownCommand);
  if (toggle != toggle_) return abort(transfer_, kToggleNotAlternated);
  CanMessage message = can::empty_frame(can::kSdoReply, node_);
  const int left = length_of(segments_);
  const int bytes = left < kSegmentBytes ? left : kSegmentBytes;
  const int last = left <= kSegmentBytes ? 1 : 0;
  message.data[0] = static_cast<uint8_t>((toggle ? 0x10 : 0) | ((kSegmentBytes - bytes) << 1) | last);
  for (int i = 0; i < bytes; ++i) message.data[1 + i] = static_cast<uint8_t>(segments_[i]);
  segments_ = last != 0 ? nullptr : segments_ + bytes;
  toggle_ = !toggle_;
  return message;
}

CanMessage SdoServer::write(const Request& request, SdoResult& result) {
  Object object;
  const uint32_t fault = find(request.index, request.subindex, object);
  if (fault != 0) return abort(request, fault);
  if (!object.writable) return abort(request, kReadOnly);
  const bool size_given = (request.command & 1) != 0;
  if (size_given && 4 - ((request.command >> 2) & 3) != object.bytes) return abort(request, kWrongLength);
  if (request.index == 0x1017) {
    const uint16_t time_ms = static_cast<uint16_t>(request.data & 0xFFFF);
    if (time_ms < kShortestHeartbeat_ms) return abort(request, kValueTooLow);
    values_.heartbeat_ms = time_ms;
    result.action = SdoAction::kHeartbeatChanged;
    return reply(kWritten, request, 0);
  }
  const bool save = request.index == 0x1010;
  if (request.data != (save ? kSignatureSave : kSignatureLoad)) return abort(request, kCannotStore);
  result.action = save ? SdoAction::kSave : SdoAction::kLoadDefaults;
  result.has_reply = false;
  pending_ = request;
  waiting_ = true;
  return CanMessage();
}

CanMessage SdoServer::confirm(bool done) {
  waiting_ = false;
  return done ? reply(kWritten, pending_, 0) : abort(pending_, kHardwareError);
}

SdoResult SdoServer::handle(const CanMessage& message) {
  SdoResult result;
  int node = 0, member = 0;
  if (!can::is_frame(can::kSdoRequest, message, node, member) || node != node_) return result;
  Request request;
  request.command = static_cast<uint8_t>(can::get_raw(message, can::kSdoSignals[0]));
  request.index = static_cast<uint16_t>(can::get_raw(message, can::kSdoSignals[1]));
  request.subindex = static_cast<uint8_t>(can::get_raw(message, can::kSdoSignals[2]));
  request.data = static_cast<uint32_t>(can::get_raw(message, can::kSdoSignals[3]));
  result.handled = true;
  result.has_reply = true;
  if (request.command == kAborted) {  // the client gives up: nothing to say
    segments_ = nullptr;
    result.has_reply = false;
  } else if (waiting_) {
    result.reply = abort(request, kNotInThisState);
  } else if ((request.command & 0xEF) == 0x60) {
    result.reply = next_segment(request);
  } else if (request.command == 0x40) {
    result.reply = read(request);
  } else if ((request.command & 0xF2) == 0x22) {
    result.reply = write(request, result);
  } else {
    result.reply = abort(request, kUnknownCommand);
  }
  return result;
}

}  // namespace firmware
