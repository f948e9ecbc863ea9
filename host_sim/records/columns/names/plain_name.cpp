#include "host_sim/records/columns/names/plain_name.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {
namespace {

using firmware::Quantity;

struct Word {
  const char* word;
  Quantity quantity;
  bool rotating;
};
constexpr Word kWords[] = {{"position", Quantity::kDisplacement, false},
                           {"pos", Quantity::kDisplacement, false},
                           {"displacement", Quantity::kDisplacement, false},
                           {"disp", Quantity::kDisplacement, false},
                           {"deflection", Quantity::kDisplacement, false},
                           {"elongation", Quantity::kDisplacement, false},
                           {"travel", Quantity::kDisplacement, false},
                           {"stroke", Quantity::kDisplacement, false},
                           {"angular_position", Quantity::kDisplacement, true},
                           {"angular_displacement", Quantity::kDisplacement, true},
                           {"angle", Quantity::kDisplacement, true},
                           {"theta", Quantity::kDisplacement, true},
                           {"phi", Quantity::kDisplacement, true},
                           {"velocity", Quantity::kVelocity, false},
                           {"vel", Quantity::kVelocity, false},
                           {"speed", Quantity::kVelocity, false},
                           {"angvel", Quantity::kVelocity, true},
                           {"omega", Quantity::kVelocity, true},
                           {"rate", Quantity::kVelocity, true},
                           {"angular_velocity", Quantity::kVelocity, true},
                           {"angular_speed", Quantity::kVelocity, true},
                           {"acceleration", Quantity::kAcceleration, false},
                           {"accel", Quantity::kAcceleration, false},
                           {"acc", Quantity::kAcceleration, false},
                           {"angular_acceleration", Quantity::kAcceleration, true},
                           {"force", Quantity::kForce, false},
                           {"load", Quantity::kForce, false},
                           {"torque", Quantity::kForce, true},
                           {"weg", Quantity::kDisplacement, false},
                           {"auslenkung", Quantity::kDisplacement, false},
                           {"winkel", Quantity::kDisplacement, true},
                           {"geschwindigkeit", Quantity::kVelocity, false},
                           {"winkelgeschwindigkeit", Quantity::kVelocity, true},
                           {"beschleunigung", Quantity::kAcceleration, false},
                           {"kraft", Quantity::kForce, false},
                           {"drehmoment", Quantity::kForce, true}};

// "phi" behind "Winkel", "s" behind "Weg": the usual symbol of the quantity, which an axis ("x", "y", "z") is not.
bool is_usual_symbol(const std::string& text, Quantity quantity) {
  static const std::map<Quantity, std::set<std::string>> kSymbols = {
      {Quantity::kDisplacement, {"s", "d", "phi", "theta", "alpha", "\u03c6", "\u03d5", "\u03b8", "\u03b1"}},
      {Quantity::kVelocity, {"v", "omega", "\u03c9"}},
      {Quantity::kAcceleration, {"a", "alpha", "\u03b1"}},
      {Quantity::kForce, {"F", "M", "tau", "\u03c4"}}};
  return kSymbols.at(quantity).count(text) != 0;
}

// "s_A1", "&b_A1": the symbol of a quantity at an input of an interface, behind its name.
bool is_symbol_at_input(const std::string& text) {
  const size_t first = text.empty() || text[0] != '&' ? 0 : 1, subscript = text.find('_');
  const size_t letters = std::min(subscript, text.size()) - std::min(first, text.size());
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const bool named = letters >= 1 && letters <= 2 &&
                     std::all_of(text.begin() + static_cast<std::ptrdiff_t>(first),
                                 text.begin() + static_cast<std::ptrdiff_t>(first + letters), is_letter);
  return named && (first == 1 || subscript != std::string::npos) && text.size() - first - letters <= 4;
}

// The word that the name is, or begins with before a "_"; what is behind it is handed out.
const Word* word_of(const std::string& name, std::string& behind) {
  std::string low = name;
  for (char& c : low) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const Word* found = nullptr;
  size_t longest = 0;
  for (const Word& w : kWords) {
    const std::string word = w.word;
    const bool whole = low == word, begins = low.compare(0, word.size() + 1, word + "_") == 0;
    if ((!whole && !begins) || word.size() < longest) continue;
    found = &w, longest = word.size(), behind = begins ? name.substr(word.size() + 1) : "";
  }
  return found;
}

}  // namespace

std::optional<PlainName> parse_plain_name(const std::string& name, const std::string& unit) {
  std::string suffix;
  const Word* word = word_of(name, suffix);
  if (word != nullptr && !unit.empty() && (is_symbol_at_input(suffix) || is_usual_symbol(suffix, word->quantity)))
    suffix.clear();
  if (word == nullptr || (!suffix.empty() && !unit.empty())) return std::nullopt;
  PlainName plain{{word->quantity, 1, word->rotating}, unit};
  if (suffix.empty() && unit.empty()) return plain;
  for (const bool rotating : {word->rotating, !word->rotating}) {
    const Dimension wanted = dimension_of(word->quantity, rotating);
    const auto found = suffix.empty() ? find_unit(unit, wanted) : find_unit_suffix(suffix, wanted);
    if (!found || found->dimension != wanted) continue;
    plain.channel.rotating = rotating;
    if (!suffix.empty()) plain.unit = found->word;
    return plain;
  }
  return std::nullopt;
}

}  // namespace host_sim
