// Lines of text with roles instead of colours, cut and padded by the columns they take on a screen.
#pragma once
#include <string>
#include <vector>

namespace live {

enum class Role { kPlain, kTitle, kHead, kGood, kDoubtful, kBad, kQuiet };

struct Span {
  std::string text;  // UTF-8, one column a character
  Role role = Role::kPlain;
};
using Line = std::vector<Span>;

int columns_of(const std::string& text);
int columns_of(const Line& line);
// At most `columns`; what is cut ends with an ellipsis ("~" where the screen knows no UTF-8).
std::string cut(const std::string& text, int columns, bool unicode);
std::string padded(const std::string& text, int columns, bool right = false);
std::string plain_text(const Line& line);  // without blanks at the end

// Fields one after another, two blanks between them, on as many lines as they need.
std::vector<Line> flow(const std::vector<Span>& fields, int width, bool unicode);

}  // namespace live
