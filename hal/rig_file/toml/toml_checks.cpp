#include "hal/rig_file/toml/toml_checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace rig_file {
namespace {

size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

const char* type_name(const toml::node& node) {
  if (node.is_string()) return "text";
  if (node.is_boolean()) return "true or false";
  if (node.is_number()) return "a number";
  if (node.is_array()) return "an array";
  return node.is_table() ? "a table" : "a date or time";
}

}  // namespace

std::string Place::key(std::string_view name) const {
  std::string result = what;
  if (!name.empty()) result += (result.empty() ? "key \"" : ", key \"") + std::string(name) + "\"";
  return result;
}

unsigned line_of(const toml::node& node) { return node.source().begin.line; }

void refuse(const Place& place, const toml::node& node, std::string_view key, const std::string& problem) {
  throw RigFileError(place.file, line_of(node), place.key(key), problem);
}

namespace {

// Letters as Latin-1 and Windows-1252 write them.
bool is_other_encoding(const toml::parse_error& error) {
  return error.description().find("utf-8") != std::string_view::npos;
}

// What was meant by a line that is no TOML: the slips of people who have not met it.
std::string expected_on(std::string_view text, unsigned line) {
  for (; line > 1 && text.find('\n') != std::string_view::npos; --line) text.remove_prefix(text.find('\n') + 1);
  text = text.substr(0, text.find_first_of("\r\n"));
  if (text.size() > 2 && text[0] == '[' && text[1] != '[' && text.find(']') != std::string_view::npos)
    return "[" + std::string(text.substr(0, text.find(']') + 1)) + "], as every one of a list is written";
  const size_t equals = text.find('=');
  const size_t value = equals == std::string_view::npos ? equals : text.find_first_not_of(" \t", equals + 1);
  if (value == std::string_view::npos) return "key = value";
  text.remove_prefix(value);
  if (std::isalpha(static_cast<unsigned char>(text[0]))) return "a word in quotes, as in \"estimate\", or a number";
  const size_t digits = text.find_first_not_of("+-0123456789");
  if (digits != 0 && digits != std::string_view::npos && text[digits] == ',')
    return text.find(", ") == std::string_view::npos ? "a decimal point, as in 2.5"
                                                     : "brackets around a list, as in [1, 2]";
  return "key = value";
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    if (is_other_encoding(error))
      throw RigFileError(file, error.source().begin.line, "",
                         "holds a letter that is not UTF-8, expected a file saved as UTF-8 (or letters of ASCII)");
    throw RigFileError(file, error.source().begin.line, "",
                       "not valid TOML (" + std::string(error.description()) + "), expected " +
                           expected_on(text, error.source().begin.line));
  }
}

toml::table parse_toml_file(const std::string& path) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  std::ifstream stream(path, std::ios::binary);
  if (!stream || folder)
    throw RigFileError(path, 0, "",
                       folder                                   ? "is a folder, expected a TOML file"
                       : std::filesystem::exists(path, ignored) ? "cannot be opened, expected a readable TOML file"
                                                                : "does not exist, expected a TOML file");
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return parse_toml(content, path);
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  const auto best = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (best == known.end() || edit_distance(word, *best) > 2 + best->size() / 3) return "";
  return *best;
}

void require_known_keys(const Place& place, const toml::table& table, const std::vector<std::string>& known) {
  for (const auto& [key, node] : table) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest_word(name, known);
    std::string expected = near.empty() ? "expected one of" : "did you mean \"" + near + "\"? Expected one of";
    for (const std::string& word : known) expected += (word == known.front() ? " " : ", ") + word;
    throw RigFileError(place.file, static_cast<unsigned>(key.source().begin.line), place.key(name),
                       "is not a known key; " + expected);
  }
}

double finite_number(const Place& place, const toml::node& node, std::string_view key) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) refuse(place, node, key, std::string("is ") + type_name(node) + ", expected a number");
  if (!std::isfinite(*value)) refuse(place, node, key, "is not finite, expected a finite number");
  return *value;
}

std::string text(const Place& place, const toml::node& node, std::string_view key) {
  const auto value = node.value_exact<std::string>();
  if (!value) refuse(place, node, key, std::string("is ") + type_name(node) + ", expected text in quotes");
  return *value;
}

int64_t whole_number(const Place& place, const toml::node& node, std::string_view key, int64_t least, int64_t most) {
  const auto value = node.value_exact<int64_t>();
  if (!value || *value < least || *value > most)
    refuse(place, node, key,
           (value ? "is " + std::to_string(*value) : std::string("is ") + type_name(node)) +
               ", expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return *value;
}

std::vector<const toml::table*> table_array(const Place& place, const toml::table& parent, std::string_view key) {
  std::vector<const toml::table*> result;
  const toml::node* node = parent.get(key);
  if (node == nullptr) return result;
  const std::string expected = "expected an array of tables, written [[" + std::string(key) + "]]";
  if (node->as_array() == nullptr) refuse(place, *node, key, std::string("is ") + type_name(*node) + ", " + expected);
  for (const toml::node& element : *node->as_array()) {
    if (element.as_table() == nullptr)
      refuse(place, element, key, std::string("holds ") + type_name(element) + ", " + expected);
    result.push_back(element.as_table());
  }
  return result;
}

}  // namespace rig_file
