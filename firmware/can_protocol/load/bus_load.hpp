// How much of the bus a stream of frames takes, at worst: with the most stuff bits that ISO 11898-1 allows and the
// three bits to the next frame. Identifiers have 11 bits.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/frame_description.hpp"

namespace firmware {
namespace can {

// Classic: 34 + 8 n bits from start to checksum, which may be stuffed (one for every four), and 13 more.
constexpr int classic_bits(int data_bytes) { return 47 + 8 * data_bytes + (34 + 8 * data_bytes - 1) / 4; }

// CAN FD with bit-rate switch: bits at the nominal and at the data rate.
struct FdBits {
  int nominal;
  int data;
};
constexpr FdBits fd_bits(int data_bytes) {
  // Nominal: start, identifier and control up to the switch, 17 and 4 stuff bits; acknowledgement, end and pause, 13.
  // Data rate: 5 + 8 n to the checksum, stuffed; stuff count 4; checksum 17 (21 above 16 bytes), a fixed stuff bit
  // every 4.
  const int checksum = 4 + (data_bytes > 16 ? 21 : 17);
  const int body = 5 + 8 * data_bytes;
  return FdBits{17 + 4 + 13, body + body / 4 + checksum + checksum / 4 + 1};
}

constexpr int64_t frame_time_ns(const FrameDescription& frame, int64_t nominal_bit_s, int64_t data_bit_s) {
  if (!frame.fd) return classic_bits(frame.length) * 1000000000ll / nominal_bit_s;
  return fd_bits(frame.length).nominal * 1000000000ll / nominal_bit_s +
         fd_bits(frame.length).data * 1000000000ll / data_bit_s;
}

// Part of the bus in per mille, rounded up, that `frames` frames of a kind take if they are sent every period.
constexpr int64_t load_permille(const FrameDescription& frame, int frames, int64_t period_us, int64_t nominal_bit_s,
                                int64_t data_bit_s = 2000000) {
  return (frames * frame_time_ns(frame, nominal_bit_s, data_bit_s) + period_us - 1) / period_us;
}

}  // namespace can
}  // namespace firmware
