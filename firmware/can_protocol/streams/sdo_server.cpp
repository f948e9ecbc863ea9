// See sdo_server.hpp. Command bytes and their bits: CiA 301, 7.2.4.3.
#include "firmware/can_protocol/streams/sdo_server.hpp"

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/configuration/bytes.hpp"

namespace firmware {
namespace {

constexpr uint8_t kReadRequest = 0x40;
constexpr uint8_t kSegmentRequest = 0x60;
constexpr uint8_t kAbort = 0x80;
constexpr uint8_t kWriteDone = 0x60;
constexpr uint8_t kReadSized = 0x43;  // expedited, size given: bits 2 and 3 count the unused bytes
constexpr uint8_t kReadSegmented = 0x41;
constexpr int kSegmentBytes = 7;

uint16_t index_of(const CanFrame& message) { return static_cast<uint16_t>(message.data[1] | message.data[2] << 8); }

}  // namespace

bool SdoServer::answer(const CanFrame& request, int node, CanFrame& reply) {
  int addressed = 0, member = 0;
  if (!can::is_frame(can::kSdoRequest, request, addressed, member) || addressed != node) return false;
  if (request.data[0] == kAbort) {
    segmented_ = false;
    return false;
  }
  reply = can::empty_frame(can::kSdoReply, node);
  for (int i = 1; i < 4; ++i) reply.data[i] = request.data[i];
  const auto command = static_cast<uint8_t>(request.data[0] & 0xE0);
  if (command == kReadRequest) {
    read_object(request, reply);
  } else if (command == kSegmentRequest) {
    next_segment(request, reply);
  } else if (command == 0x20) {
    return write_object(request, reply);
  } else {
    abort(SdoAbort::kCommand, reply);
  }
  return true;
}

void SdoServer::abort(SdoAbort code, CanFrame& reply) {
  segmented_ = false;
  reply.data[0] = kAbort;
  put32(reply.data + 4, static_cast<uint32_t>(code));
}

void SdoServer::read_object(const CanFrame& request, CanFrame& reply) {
  const SdoAbort code = objects_.read(index_of(request), request.data[3], bytes_, size_);
  if (code != SdoAbort::kNone) return abort(code, reply);
  segmented_ = size_ > 4;
  sent_ = 0;
  toggle_ = false;
  if (segmented_) {
    reply.data[0] = kReadSegmented;
    put32(reply.data + 4, size_);
    return;
  }
  reply.data[0] = static_cast<uint8_t>(kReadSized | (4 - size_) << 2);
  for (int i = 0; i < size_; ++i) reply.data[4 + i] = bytes_[i];
}

void SdoServer::next_segment(const CanFrame& request, CanFrame& reply) {
  if (!segmented_) return abort(SdoAbort::kCommand, reply);
  if (((request.data[0] & 0x10) != 0) != toggle_) return abort(SdoAbort::kToggle, reply);
  const int left = size_ - sent_;
  const int now = left < kSegmentBytes ? left : kSegmentBytes;
  const bool last = left <= kSegmentBytes;
  reply.data[0] = static_cast<uint8_t>((toggle_ ? 0x10 : 0) | (kSegmentBytes - now) << 1 | (last ? 1 : 0));
  for (int i = 0; i < kSegmentBytes; ++i) reply.data[1 + i] = i < now ? bytes_[sent_ + i] : uint8_t{0};
  sent_ = static_cast<uint8_t>(sent_ + now);
  toggle_ = !toggle_;
  segmented_ = !last;
}

// False: not answered yet.
bool SdoServer::write_object(const CanFrame& request, CanFrame& reply) {
  segmented_ = false;
  const uint8_t command = request.data[0];
  const bool expedited = command & 0x02;
  if (!expedited || waiting_) {
    abort(expedited ? SdoAbort::kDeviceState : SdoAbort::kCommand, reply);
    return true;
  }
  const bool sized = command & 0x01;
  const auto size = static_cast<uint8_t>(sized ? 4 - ((command >> 2) & 3) : 0);  // 0: not said
  uint32_t value = get32(request.data + 4);
  if (sized && size < 4) value &= (1u << (8 * size)) - 1;
  const SdoAbort code = objects_.write(index_of(request), request.data[3], value, size);
  pending_ = reply;
  waiting_ = code == SdoAbort::kPending;
  if (!waiting_) reply = complete(code);
  return !waiting_;
}

CanFrame SdoServer::complete(SdoAbort code) {
  CanFrame reply = pending_;
  waiting_ = false;
  if (code == SdoAbort::kNone)
    reply.data[0] = kWriteDone;
  else
    abort(code, reply);
  return reply;
}

}  // namespace firmware
