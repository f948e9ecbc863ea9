// The data elements that a MAT file of version 5 consists of. Format: "MAT-File Format", The MathWorks.
#pragma once
#include <cstdint>
#include <string_view>

namespace host_sim::mat {

enum ElementType : uint32_t { kInt8 = 1, kUint32 = 6, kMatrix = 14, kCompressed = 15 };

struct Element {
  uint32_t type = 0;
  uint64_t bytes = 0;     // that it says to have
  std::string_view data;  // those of them that are there
};

// Goes from element to element of a file or of a matrix.
class Elements {
 public:
  Elements(std::string_view bytes, bool big_endian) : rest_(bytes), big_endian_(big_endian) {}
  // False at the end. What is not compressed fills up to eight bytes; one of up to four bytes may share eight with its type.
  bool next(Element& element);
  uint32_t word(std::string_view bytes, size_t at) const;
  bool big_endian() const { return big_endian_; }

 private:
  std::string_view rest_;
  bool big_endian_;
};

}  // namespace host_sim::mat
