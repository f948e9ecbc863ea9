#include "host_sim/records/csv/text/text_encoding.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>

namespace host_sim {
namespace {

enum class Encoding { kBytes, kUtf16Little, kUtf16Big };

// Without a mark: ASCII as UTF-16 has a zero in every second byte.
Encoding encoding_of(std::string_view content) {
  if (content.substr(0, 2) == "\xFF\xFE") return Encoding::kUtf16Little;
  if (content.substr(0, 2) == "\xFE\xFF") return Encoding::kUtf16Big;
  const std::string_view head = content.substr(0, 64);
  size_t even = 0, odd = 0;
  for (size_t i = 0; i < head.size(); ++i) (i % 2 == 0 ? even : odd) += head[i] == '\0' ? 1 : 0;
  if (head.size() < 8) return Encoding::kBytes;
  if (odd > head.size() / 3 && even == 0) return Encoding::kUtf16Little;
  if (even > head.size() / 3 && odd == 0) return Encoding::kUtf16Big;
  return Encoding::kBytes;
}

void append_utf8(uint32_t code, std::string& out) {
  const auto put = [&out](uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

// Beyond the basic plane nothing of ours is written: a surrogate becomes a question mark.
std::string from_utf16(std::string_view content, bool big) {
  std::string out;
  out.reserve(content.size() / 2);
  for (size_t i = 0; i + 1 < content.size(); i += 2) {
    const auto first = static_cast<uint8_t>(content[i]), second = static_cast<uint8_t>(content[i + 1]);
    const uint32_t code = big ? static_cast<uint32_t>(first) << 8 | second : static_cast<uint32_t>(second) << 8 | first;
    if (i == 0 && code == 0xFEFF) continue;
    append_utf8(code >= 0xD800 && code < 0xE000 ? '?' : code, out);
  }
  return out;
}

// How many bytes at the front are one letter of UTF-8; 0: they are none.
size_t letter_length(std::string_view text) {
  const auto first = static_cast<uint8_t>(text.front());
  const size_t length = first < 0x80   ? 1
                        : first < 0xC2 ? 0
                        : first < 0xE0 ? 2
                        : first < 0xF0 ? 3
                        : first < 0xF5 ? 4
                                       : 0;
  if (length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i)
    if ((static_cast<uint8_t>(text[i]) & 0xC0) != 0x80) return 0;
  return length;
}

// The first byte that is no letter of UTF-8, or the end. Eight by eight: nearly all of a table is ASCII.
size_t first_foreign(std::string_view text, size_t from) {
  for (size_t at = from; at < text.size();) {
    uint64_t eight = 0;
    if (at + sizeof eight <= text.size()) {
      std::memcpy(&eight, text.data() + at, sizeof eight);
      if ((eight & 0x8080808080808080) == 0) {
        at += sizeof eight;
        continue;
      }
    }
    const size_t length = letter_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return text.size();
}

// Bytes that are no UTF-8 are Windows-1252's, which has Latin-1's letters and more signs.
std::string with_windows_letters(std::string_view content, size_t foreign) {
  constexpr uint16_t kSigns[32] = {0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
  std::string out;
  out.reserve(content.size() + content.size() / 64);
  for (size_t at = 0; at < content.size(); foreign = first_foreign(content, at)) {
    out.append(content, at, foreign - at);
    if (foreign == content.size()) break;
    const auto byte = static_cast<uint8_t>(content[foreign]);
    append_utf8(byte < 0xA0 ? kSigns[byte - 0x80] : byte, out);
    at = foreign + 1;
  }
  return out;
}

}  // namespace

std::string_view as_utf8(std::string_view content, std::string& buffer) {
  const Encoding encoding = encoding_of(content);
  if (encoding != Encoding::kBytes) {
    buffer = from_utf16(content, encoding == Encoding::kUtf16Big);
    content = buffer;
  }
  if (content.substr(0, 3) == "\xEF\xBB\xBF") content.remove_prefix(3);
  const std::string_view head = content.substr(0, 1 << 16);
  if (head.find('\n') == std::string_view::npos && head.find('\r') != std::string_view::npos) {
    buffer = std::string(content);
    std::replace(buffer.begin(), buffer.end(), '\r', '\n');
    content = buffer;
  }
  if (const size_t foreign = first_foreign(content, 0); foreign < content.size()) {
    buffer = with_windows_letters(content, foreign);
    content = buffer;
  }
  return content;
}

namespace {

// A tag of XML or HTML, and behind it the end of the line, text or another tag; "<DATE>;<TIME>" are names of columns.
bool begins_with_tag(std::string_view content) {
  const size_t first = content.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || content[first] != '<') return false;
  content.remove_prefix(first + 1);
  const char kind = content.empty() ? ' ' : content[0];
  if (kind == '?' || kind == '!') return true;
  const size_t end = content.find('>');
  if (std::isalpha(static_cast<unsigned char>(kind)) == 0 || end == std::string_view::npos) return false;
  const std::string_view rest = content.substr(end + 1, content.find('\n', end) - (end + 1));
  return rest.empty() || rest.find_first_not_of(" \t\r") == std::string_view::npos ||
         std::string_view(",; \t").find(rest[0]) == std::string_view::npos;
}

}  // namespace

const char* other_format(std::string_view content) {
  constexpr struct {
    std::string_view begins;
    const char* is;
  } kOthers[] = {{"PK\x03\x04", "an Excel workbook or another archive"},
                 {"\xD0\xCF\x11\xE0", "an old Excel workbook"},
                 {"\x93NUMPY", "a NumPy array (.npy; numpy.savetxt writes what is read)"},
                 {"\x1F\x8B", "compressed by gzip (gunzip writes what is read)"},
                 {"TDSm", "a TDMS file"},
                 {"{", "JSON"},
                 {"[{", "JSON"},
                 {"%PDF", "a PDF"}};
  constexpr size_t kNames = 200;  // of the first file of an archive, and what stands before them
  if (content.substr(0, 4) == "PK\x03\x04" && content.substr(0, kNames).find(".npy") != std::string_view::npos)
    return "a NumPy archive (.npz; scipy.io.savemat writes what is read)";
  for (const auto& other : kOthers)
    if (content.substr(0, other.begins.size()) == other.begins) return other.is;
  if (begins_with_tag(content)) return "XML or HTML (its values are exported by the program that wrote it)";
  return nullptr;
}

}  // namespace host_sim
