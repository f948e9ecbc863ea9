#include "host_sim/ingestion/mat/mat_elements.hpp"

#include <algorithm>

namespace host_sim::mat {

uint32_t Elements::word(std::string_view bytes, size_t at) const {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i)
    value |= static_cast<uint32_t>(static_cast<uint8_t>(bytes[at + i])) << (8 * (big_endian_ ? 3 - i : i));
  return value;
}

bool Elements::next(Element& element) {
  if (rest_.size() < 8) return false;
  const uint32_t first = word(rest_, 0);
  const bool is_small = first >> 16 != 0;
  element.type = is_small ? first & 0xFFFF : first;
  element.bytes = is_small ? first >> 16 : word(rest_, 4);
  if (is_small && element.bytes > 4) return false;
  const uint64_t filled = element.type == kCompressed ? element.bytes : (element.bytes + 7) / 8 * 8;
  element.data = rest_.substr(is_small ? 4 : 8, element.bytes);
  rest_.remove_prefix(static_cast<size_t>(std::min<uint64_t>(rest_.size(), is_small ? 8 : 8 + filled)));
  return true;
}

}  // namespace host_sim::mat
