#include "host_sim/ingestion/mat/mat_sizes.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "host_sim/ingestion/mat/mat_elements.hpp"
#include "host_sim/ingestion/mat/mat_values.hpp"

namespace host_sim {
namespace {

using mat::Element;
using mat::Elements;

constexpr size_t kFileHead = 128, kTag = 8;
constexpr uint32_t kCell = 1, kStruct = 2, kText = 4, kFirstNumeric = 6, kLastNumeric = 15;  // classes of a matrix
constexpr int kDeepest = 30;
constexpr uint64_t kLettersLess = 64;  // MATLAB leaves single letters without bytes

// Bytes of a number of that type of element; 0: none of numbers.
uint64_t width_of(uint32_t type) {
  constexpr uint8_t kWidths[] = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8, 0, 0, 1, 2, 4};
  return type < std::size(kWidths) ? kWidths[type] : 0;
}

uint64_t product(uint64_t a, uint64_t b) {
  return b != 0 && a > std::numeric_limits<uint64_t>::max() / b ? std::numeric_limits<uint64_t>::max() : a * b;
}

[[noreturn]] void refuse(const std::string& file, const std::string& name, uint64_t claimed, const char* what,
                         uint64_t there) {
  mat::fail(file, name,
            "is to hold " + std::to_string(claimed) + " " + what + ", and its bytes are those of " +
                std::to_string(there) + ": the file is damaged, copy it from its source again");
}

class Sizes {
 public:
  Sizes(const std::string& file, const MatLibrary& library) : file_(file), library_(library) {}

  void check_all(Elements elements) {
    for (Element element; elements.next(element);) {
      if (element.type == mat::kMatrix) check(element.data, elements.big_endian(), "", 0);
      if (element.type == mat::kCompressed) check_compressed(element.data, elements.big_endian());
    }
  }

 private:
  // bytes: of a matrix, or its first. outer: what it stands in, where it has no name of its own.
  void check(std::string_view bytes, bool big_endian, const std::string& outer, int depth) {
    Elements parts(bytes, big_endian);
    Element flags, sizes, name;
    if (depth > kDeepest || !parts.next(flags) || flags.data.size() < 8) return;
    if (!parts.next(sizes) || !parts.next(name)) return;
    const uint32_t kind = parts.word(flags.data, 0) & 0xFF;
    uint64_t count = 1;
    for (size_t at = 0; at + 4 <= sizes.data.size(); at += 4) count = product(count, parts.word(sizes.data, at));
    const std::string called = name.data.empty() ? outer : std::string(name.data);
    if ((kind >= kFirstNumeric && kind <= kLastNumeric) || kind == kText) check_numbers(parts, kind, count, called);
    if (kind == kCell || kind == kStruct) check_members(parts, kind, count, called, depth);
  }

  // Text may take several bytes for a letter.
  void check_numbers(Elements parts, uint32_t kind, uint64_t count, const std::string& name) {
    for (Element numbers; parts.next(numbers);) {  // the imaginary ones are a second element
      const uint64_t width = width_of(numbers.type);
      if (width == 0) continue;
      const uint64_t there = numbers.bytes / width;
      if (kind == kText ? count > there + kLettersLess : product(count, width) != numbers.bytes)
        refuse(file_, name, count, kind == kText ? "letters" : "numbers", there);
    }
  }

  void check_members(Elements parts, uint32_t kind, uint64_t count, const std::string& name, int depth) {
    Element length, names;
    uint64_t fields = 1;
    if (kind == kStruct) {
      if (!parts.next(length) || length.data.size() < 4 || !parts.next(names)) return;
      const uint64_t letters = parts.word(length.data, 0);
      fields = letters == 0 ? 0 : names.bytes / letters;
    }
    uint64_t there = 0;
    for (Element member; parts.next(member);) {
      if (member.type != mat::kMatrix) continue;
      ++there;
      check(member.data, parts.big_endian(), name, depth + 1);
    }
    if (fields > 0 && product(count, fields) > there)
      refuse(file_, name, count, kind == kStruct ? "elements of a struct" : "cells", there / fields);
  }

  // Of numbers the first bytes are enough; a struct has its sizes all over.
  void check_compressed(std::string_view packed, bool big_endian) {
    constexpr size_t kEnough = 4096, kMostPacked = 1040;  // bytes that one of a compressed element may stand for
    const std::string head = unpacked(packed, kTag);
    Elements tag(head, big_endian);
    if (head.size() < kTag || tag.word(head, 0) != mat::kMatrix) return;
    const uint64_t whole = kTag + uint64_t{tag.word(head, 4)};
    if (whole > product(packed.size() + 1, kMostPacked)) return;
    std::string first = unpacked(packed, static_cast<size_t>(std::min<uint64_t>(whole, kEnough)));
    const uint32_t kind = first.size() >= 3 * kTag ? tag.word(first, 2 * kTag) & 0xFF : 0;
    if (kind == kCell || kind == kStruct) first = unpacked(packed, static_cast<size_t>(whole));
    if (first.size() > kTag) check(std::string_view(first).substr(kTag), big_endian, "", 0);
  }

  // The first bytes of what was compressed; fewer where there are no more.
  std::string unpacked(std::string_view packed, size_t count) const {
    std::string bytes(count, '\0');
    unsigned long length = count;
    if (library_.unpack == nullptr) return "";
    library_.unpack(reinterpret_cast<unsigned char*>(bytes.data()), &length,
                    reinterpret_cast<const unsigned char*>(packed.data()), packed.size());
    bytes.resize(std::min<size_t>(length, count));
    return bytes;
  }

  const std::string& file_;
  const MatLibrary& library_;
};

}  // namespace

void require_sizes_of_mat(std::string_view content, const std::string& file, const MatLibrary& library) {
  if (content.size() < kFileHead || content.substr(0, 4) != "MATL") return;
  const std::string_view end = content.substr(kFileHead - 4, 4), little("\0\1IM", 4), big("\1\0MI", 4);
  if (end != little && end != big) return;
  Sizes(file, library).check_all(Elements(content.substr(kFileHead), end == big));
}

}  // namespace host_sim
