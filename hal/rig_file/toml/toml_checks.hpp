// Reading a TOML table strictly: every key must be known, every value of its type; a fault names file, line and key.
#pragma once
#include <toml++/toml.h>

#include <string>
#include <vector>

#include "hal/rig_file/rig_file_error.hpp"

namespace rig_file {

// A table with the place that messages name: "link 2".
struct Place {
  const std::string& file;
  std::string what;                              // empty at top level
  std::string key(std::string_view name) const;  // link 2, key "between"
};

toml::table parse_toml_file(const std::string& path);                    // throws RigFileError
toml::table parse_toml(std::string_view text, const std::string& file);  // throws RigFileError

unsigned line_of(const toml::node& node);

[[noreturn]] void refuse(const Place& place, const toml::node& node, std::string_view key, const std::string& problem);

// Refuses a key that is not in the list, with the nearest known one as a suggestion.
void require_known_keys(const Place& place, const toml::table& table, const std::vector<std::string>& known);
// The nearest word by edit distance, empty where nothing is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

double finite_number(const Place& place, const toml::node& node, std::string_view key);
std::string text(const Place& place, const toml::node& node, std::string_view key);
int64_t whole_number(const Place& place, const toml::node& node, std::string_view key, int64_t least, int64_t most);

// The elements of an array of tables ([[dof]]); empty where the key is absent. Refuses anything else of that name.
std::vector<const toml::table*> table_array(const Place& place, const toml::table& parent, std::string_view key);

}  // namespace rig_file
