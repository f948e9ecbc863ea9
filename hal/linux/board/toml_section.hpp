// One table of the board's file, read strictly: what is absent keeps its default, what is there must be of its type and
// range.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/toml/toml_checks.hpp"

namespace board {

// A number as a message has it: "2.5", "4000".
std::string readable(double value);

class Section {
 public:
  // name as messages show it: "can", "excitation level 2". A missing table reads as an empty one.
  Section(const std::string& file, std::string name, const toml::table* table, const std::vector<std::string>& known);

  bool present() const { return table_ != nullptr; }
  bool has(const char* key) const { return node(key) != nullptr; }
  double number(const char* key, double otherwise, double least, double most) const;
  int64_t whole(const char* key, int64_t otherwise, int64_t least, int64_t most) const;
  std::string text(const char* key, const std::string& otherwise) const;
  bool flag(const char* key, bool otherwise) const;
  // The place of the word in the list; index 0 is the default.
  size_t choice(const char* key, const std::vector<std::string>& words) const;
  const toml::node* node(const char* key) const { return table_ == nullptr ? nullptr : table_->get(key); }

  // Throws rig_file::RigFileError at the key, or at the table where the key is absent.
  [[noreturn]] void refuse(const char* key, const std::string& problem) const;

 private:
  rig_file::Place place_;
  const toml::table* table_;
};

// The table of that name in a parent; refuses anything else of that name. Null where it is absent.
const toml::table* sub_table(const std::string& file, const toml::table& parent, const char* key);

}  // namespace board
