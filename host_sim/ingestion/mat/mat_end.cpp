#include "host_sim/ingestion/mat/mat_end.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace host_sim {
namespace {

constexpr uint64_t kHeader5 = 128, kHeader4 = 20;
constexpr uint32_t kCompressed = 15;
constexpr uint64_t kMostNumbers = uint64_t{1} << 48;  // of a matrix; more are a head that is damaged

class Words {
 public:
  explicit Words(const std::string& path) : file_(path, std::ios::binary | std::ios::ate) {
    size_ = file_ ? static_cast<uint64_t>(file_.tellg()) : 0;
  }
  uint64_t size() const { return size_; }
  void turn_over() { turned_ = true; }
  template <size_t kCount>
  bool read(uint64_t at, uint32_t (&words)[kCount]) {
    unsigned char bytes[4 * kCount];
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at));
    if (!file_.read(reinterpret_cast<char*>(bytes), sizeof bytes)) return false;
    for (size_t i = 0; i < kCount; ++i) {
      if (turned_) std::reverse(bytes + 4 * i, bytes + 4 * i + 4);
      std::memcpy(&words[i], bytes + 4 * i, 4);
    }
    return true;
  }

 private:
  std::ifstream file_;
  uint64_t size_ = 0;
  bool turned_ = false;  // of the other order of bytes
};

// Type and length of each; what is not compressed fills up to eight bytes.
uint64_t end_of_version_5(Words& words) {
  uint64_t at = kHeader5;
  for (uint32_t tag[2]; at < words.size() && words.read(at, tag);) {
    const uint64_t length = tag[1];
    at += 8 + (tag[0] == kCompressed ? length : (length + 7) / 8 * 8);
  }
  return at;
}

// Type MOPT, rows, columns, whether imaginary, length of the name. P: kind of the numbers.
uint64_t end_of_version_4(Words& words) {
  constexpr uint64_t kBytes[] = {8, 4, 4, 2, 2, 1};
  uint64_t at = 0;
  for (uint32_t head[5]; at < words.size() && words.read(at, head);) {
    const uint32_t kind = head[0] / 10 % 10;
    if (head[0] > 5000 || kind >= std::size(kBytes) || head[0] % 10 > 1) return 0;  // full and text matrices alone
    if (head[1] != 0 && head[2] > kMostNumbers / head[1]) return 0;
    at += kHeader4 + head[4] + kBytes[kind] * head[1] * head[2] * (head[3] != 0 ? 2 : 1);
  }
  return at;
}

}  // namespace

uint64_t missing_mat_bytes(const std::string& path) {
  Words words(path);
  uint32_t last[1], first[1];
  if (!words.read(0, first)) return 0;
  uint64_t end = 0;
  if (words.size() >= kHeader5 && std::memcmp(first, "MATL", 4) == 0) {
    if (!words.read(kHeader5 - 4, last)) return 0;
    const uint32_t mark = last[0] >> 16, version = last[0] & 0xFFFF;
    const bool own_order = mark == 0x4D49;  // "MI" as a number of this machine
    if (own_order ? version != 0x0100 : last[0] != 0x494D0001) return 0;
    if (!own_order) words.turn_over();
    end = end_of_version_5(words);
  } else if (first[0] <= 5000 || __builtin_bswap32(first[0]) <= 5000) {
    if (first[0] > 5000) words.turn_over();
    end = end_of_version_4(words);
  }
  return end > words.size() ? end - words.size() : 0;
}

}  // namespace host_sim
