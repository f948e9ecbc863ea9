#include "host_sim/records/columns/units/unit_spelling.hpp"

namespace host_sim {
namespace {

struct Spelling {
  const char* from;
  const char* to;
};
// Signs of UTF-8 and Latin-1, and what says nothing.
constexpr Spelling kSpellings[] = {{"\xC2\xB5", "u"},
                                   {"\xCE\xBC", "u"},
                                   {"\xC2\xB0", "deg"},
                                   {"\xC2\xB2", "2"},
                                   {"\xC2\xB7", ""},
                                   {"\xE2\x8B\x85", ""},
                                   {"\xE2\x81\xBB", ""},
                                   {"\xC2\xB9", "1"},
                                   {"\xB5", "u"},
                                   {"\xB0", "deg"},
                                   {"\xB2", "2"},
                                   {"\xB7", ""},
                                   {"**", ""},
                                   {" ", ""},
                                   {"*", ""},
                                   {"^", ""},
                                   {"-", ""},
                                   {".", ""},
                                   {"(", ""},
                                   {")", ""},
                                   {"[", ""},
                                   {"]", ""},
                                   {"{", ""},
                                   {"}", ""},
                                   {"\"", ""},
                                   {"\t", ""},
                                   {"_", ""}};

}  // namespace

std::string plain_spelling(std::string_view text) {
  std::string out(text.substr(0, 40));
  for (const Spelling& spelling : kSpellings)
    for (size_t at = out.find(spelling.from); at != std::string::npos; at = out.find(spelling.from, at))
      out.replace(at, std::char_traits<char>::length(spelling.from), spelling.to);
  return out;
}

}  // namespace host_sim
