#include "host_sim/live/screen/text.hpp"

#include <algorithm>

namespace live {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }  // not the first byte of a character

}  // namespace

int columns_of(const std::string& text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

int columns_of(const Line& line) {
  int columns = 0;
  for (const Span& span : line) columns += columns_of(span.text);
  return columns;
}

std::string cut(const std::string& text, int columns, bool unicode) {
  if (columns_of(text) <= columns) return text;
  if (columns <= 0) return "";
  size_t end = 0;
  for (int kept = 0; end < text.size(); ++end)
    if (!continues(text[end]) && kept++ == columns - 1) break;
  return text.substr(0, end) + (unicode ? "…" : "~");
}

std::string padded(const std::string& text, int columns, bool right) {
  const std::string blanks(static_cast<size_t>(std::max(0, columns - columns_of(text))), ' ');
  return right ? blanks + text : text + blanks;
}

std::string plain_text(const Line& line) {
  std::string text;
  for (const Span& span : line) text += span.text;
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::vector<Line> flow(const std::vector<Span>& fields, int width, bool unicode) {
  constexpr int kGap = 2;
  std::vector<Line> lines(1);
  for (const Span& field : fields) {
    if (field.text.empty()) continue;
    const int taken = columns_of(lines.back());
    if (taken > 0 && taken + kGap + columns_of(field.text) > width) lines.emplace_back();
    if (!lines.back().empty()) lines.back().push_back({std::string(kGap, ' '), Role::kPlain});
    lines.back().push_back({cut(field.text, width, unicode), field.role});
  }
  return lines;
}

}  // namespace live
