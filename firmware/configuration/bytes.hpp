// Numbers in bytes, the same on every machine: little-endian words, and the check sum of zip and Ethernet.
#pragma once
#include <cstddef>
#include <cstdint>

namespace firmware {

inline void put32(uint8_t* bytes, uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<uint8_t>(value >> (8 * i));
}

inline uint32_t get32(const uint8_t* bytes) {
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= static_cast<uint32_t>(bytes[i]) << (8 * i);
  return value;
}

// CRC-32: polynomial 0xEDB88320 (reflected), from all ones, inverted at the end.
class Crc32 {
 public:
  void add(uint8_t byte) {
    value_ ^= byte;
    for (int bit = 0; bit < 8; ++bit) value_ = (value_ >> 1) ^ (0xEDB88320u & (0u - (value_ & 1u)));
  }
  uint32_t value() const { return ~value_; }

 private:
  uint32_t value_ = 0xFFFFFFFFu;
};

inline uint32_t crc32(const uint8_t* bytes, size_t size) {
  Crc32 crc;
  for (size_t i = 0; i < size; ++i) crc.add(bytes[i]);
  return crc.value();
}

}  // namespace firmware
