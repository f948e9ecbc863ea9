#include "host_sim/records/csv/text/text_encoding.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

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
    if (encoding == Encoding::kBytes) buffer.assign(content.data(), content.size());
    const size_t skipped = encoding == Encoding::kBytes ? 0 : static_cast<size_t>(content.data() - buffer.data());
    std::replace(buffer.begin(), buffer.end(), '\r', '\n');
    content = std::string_view(buffer).substr(skipped);
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
