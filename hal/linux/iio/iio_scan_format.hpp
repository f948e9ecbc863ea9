// How the kernel lays one scan of an IIO buffer out in bytes, and the values in it. Pure: bytes in, numbers out.
//
// Each channel has a type text in sysfs, "[be|le]:[s|u]bits/storagebits[Xrepeat][>>shift]", and an index. A scan holds
// the enabled channels by rising index, each aligned to its own whole size (repeats included); the scan's size is
// rounded up to the largest of these. Documentation/driver-api/iio/buffers.rst of the kernel.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hal {

struct ScanType {
  bool big_endian = false;
  bool is_signed = false;
  uint8_t bits = 0;          // valid ones, 1 to 64
  uint8_t storage_bits = 0;  // 8, 16, 32 or 64
  uint8_t repeat = 1;        // elements of this type one after another (a quaternion has 4)
  uint8_t shift = 0;         // to the right, after the bytes are in order
};

// False where the text does not follow the pattern or cannot be: bits + shift over storage bits, storage of other
// sizes.
bool parse_scan_type(std::string_view text, ScanType& type);

// The bytes of one element, sign extended, shifted. bytes: at least storage_bits / 8.
int64_t decode_element(const ScanType& type, const uint8_t* bytes);

constexpr int kMaxScanElements = 64;

// Filled by add() with rising index, closed by reading size().
class ScanLayout {
 public:
  // Returns the byte offset of the new element in a scan, -1 where there is no room for more.
  int add(const ScanType& type);
  size_t size() const;  // bytes of one scan
  int count() const { return count_; }

 private:
  size_t end_ = 0;
  size_t largest_ = 1;
  int count_ = 0;
};

}  // namespace hal
