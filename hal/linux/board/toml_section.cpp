#include "hal/linux/board/toml_section.hpp"

#include <algorithm>
#include <sstream>

namespace board {

std::string readable(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

Section::Section(const std::string& file, std::string name, const toml::table* table,
                 const std::vector<std::string>& known)
    : place_{file, std::move(name)}, table_(table) {
  if (table_ != nullptr) rig_file::require_known_keys(place_, *table_, known);
}

void Section::refuse(const char* key, const std::string& problem) const {
  const toml::node* at = node(key);
  if (at != nullptr) rig_file::refuse(place_, *at, key, problem);
  if (table_ != nullptr) rig_file::refuse(place_, *table_, key, problem);
  throw rig_file::RigFileError(place_.file, 0, place_.key(key), problem);
}

double Section::number(const char* key, double otherwise, double least, double most) const {
  if (!has(key)) return otherwise;
  const double value = rig_file::finite_number(place_, *node(key), key);
  if (value < least || value > most)
    refuse(key, "is " + readable(value) + ", expected " + readable(least) + " to " + readable(most));
  return value;
}

int64_t Section::whole(const char* key, int64_t otherwise, int64_t least, int64_t most) const {
  return has(key) ? rig_file::whole_number(place_, *node(key), key, least, most) : otherwise;
}

std::string Section::text(const char* key, const std::string& otherwise) const {
  return has(key) ? rig_file::text(place_, *node(key), key) : otherwise;
}

bool Section::flag(const char* key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const auto value = node(key)->value_exact<bool>();
  if (!value) refuse(key, "is neither true nor false, expected one of them");
  return *value;
}

size_t Section::choice(const char* key, const std::vector<std::string>& words) const {
  const std::string word = text(key, words.front());
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<size_t>(found - words.begin());
  std::string expected;
  for (const std::string& each : words) expected += (expected.empty() ? "\"" : ", \"") + each + "\"";
  refuse(key, "is \"" + word + "\", expected one of " + expected);
}

const toml::table* sub_table(const std::string& file, const toml::table& parent, const char* key) {
  const toml::node* node = parent.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) rig_file::refuse({file, ""}, *node, key, "is no table, expected [" + std::string(key) + "]");
  return node->as_table();
}

}  // namespace board
