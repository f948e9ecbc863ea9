#include "hal/linux/iio/iio_scan_format.hpp"

#include <algorithm>
#include <charconv>

namespace hal {
namespace {

bool skip(std::string_view& text, std::string_view word) {
  if (text.substr(0, word.size()) != word) return false;
  text.remove_prefix(word.size());
  return true;
}

bool number(std::string_view& text, uint8_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

size_t align(size_t offset, size_t size) { return (offset + size - 1) / size * size; }

size_t bytes_of(const ScanType& type) { return static_cast<size_t>(type.storage_bits) / 8 * type.repeat; }

}  // namespace

bool parse_scan_type(std::string_view text, ScanType& type) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
  ScanType parsed;
  parsed.big_endian = text.substr(0, 3) == "be:";
  if (!skip(text, "be:") && !skip(text, "le:")) return false;
  parsed.is_signed = text.substr(0, 1) == "s";
  if (!skip(text, "s") && !skip(text, "u")) return false;
  if (!number(text, parsed.bits) || !skip(text, "/") || !number(text, parsed.storage_bits)) return false;
  if (skip(text, "X") && !number(text, parsed.repeat)) return false;
  if (skip(text, ">>") && !number(text, parsed.shift)) return false;
  const uint8_t storage = parsed.storage_bits;
  const bool whole = storage == 8 || storage == 16 || storage == 32 || storage == 64;
  if (!text.empty() || !whole || parsed.bits == 0 || parsed.repeat == 0 || parsed.bits + parsed.shift > storage)
    return false;
  type = parsed;
  return true;
}

int64_t decode_element(const ScanType& type, const uint8_t* bytes) {
  const int count = type.storage_bits / 8;
  uint64_t word = 0;
  for (int i = 0; i < count; ++i) word = word << 8 | bytes[type.big_endian ? i : count - 1 - i];
  word >>= type.shift;
  const int unused = 64 - type.bits;
  word <<= unused;
  return type.is_signed ? static_cast<int64_t>(word) >> unused : static_cast<int64_t>(word >> unused);
}

int ScanLayout::add(const ScanType& type) {
  if (count_ == kMaxScanElements) return -1;
  const size_t size = bytes_of(type);
  const size_t offset = align(end_, size);
  end_ = offset + size;
  largest_ = std::max(largest_, size);
  ++count_;
  return static_cast<int>(offset);
}

size_t ScanLayout::size() const { return align(end_, largest_); }

}  // namespace hal
