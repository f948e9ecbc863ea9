#include "host_sim/records/columns/units/units.hpp"

#include "host_sim/records/columns/units/counted.hpp"
#include "host_sim/records/columns/units/unit_spelling.hpp"
#include "host_sim/records/columns/units/unit_table.hpp"

namespace host_sim {
namespace {

bool same(std::string_view a, std::string_view b, bool with_case) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    if (with_case ? a[i] != b[i] : lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

// The one row that reads so; in other case only where that leaves one meaning.
std::optional<Unit> row_of(const std::string& word, std::optional<Dimension> expected) {
  const UnitRow* found = nullptr;
  for (const bool with_case : {true, false}) {
    for (const UnitRow& row : unit_rows()) {
      if (!same(word, row.word, with_case) || (expected && row.dimension != *expected)) continue;
      if (found != nullptr && found->to_si != row.to_si) return std::nullopt;
      found = &row;
    }
    if (found != nullptr) return Unit{found->word, found->dimension, found->to_si};
  }
  return std::nullopt;
}

}  // namespace

Dimension dimension_of(firmware::Quantity quantity, bool rotating) {
  return static_cast<Dimension>(static_cast<int>(quantity) + (rotating ? static_cast<int>(Dimension::kTorque) : 0));
}

const char* si_unit(Dimension dimension) {
  if (dimension == Dimension::kTorque) return "N m";
  for (const UnitRow& row : unit_rows())
    if (row.dimension == dimension && row.to_si == 1.0) return row.word;
  return "";
}

std::optional<Unit> find_unit(std::string_view text, std::optional<Dimension> expected) {
  const std::string word = plain_spelling(text);
  if (word.empty()) return std::nullopt;
  if (expected)
    if (const auto unit = row_of(word, expected)) return unit;
  return row_of(word, std::nullopt);
}

std::optional<Unit> find_scaled_unit(const std::string& text, Dimension expected) {
  if (const auto unit = find_unit(text, expected)) return unit;  // "1/min" is a unit
  const auto counted = take_count(text);
  if (!counted) return std::nullopt;
  auto unit = find_unit(counted->rest, expected);
  if (!unit) return std::nullopt;
  unit->word = std::string(counted->said) + " " + unit->word;
  unit->to_si *= counted->count;
  return unit;
}

std::optional<Unit> find_unit_suffix(std::string_view suffix, Dimension expected) {
  std::string word(suffix);
  for (char& c : word)
    if (c == '_') c = '/';
  if (const auto unit = find_unit(word, expected); unit && unit->dimension == expected) return unit;
  return find_unit(suffix, expected);
}

}  // namespace host_sim
