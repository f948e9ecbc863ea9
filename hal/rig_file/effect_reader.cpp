#include "hal/rig_file/effect_reader.hpp"

namespace rig_file {
namespace {

std::vector<std::string> kinds_of(EffectPlace where) {
  std::vector<std::string> kinds;
  for (const EffectWord& word : effect_words())
    if (word.place == where) kinds.emplace_back(word.kind);
  return kinds;
}

const EffectWord& read_kind(const Place& place, const toml::table& table, EffectPlace where) {
  const std::vector<std::string> kinds = kinds_of(where);
  std::string all;
  for (const std::string& kind : kinds) all += (all.empty() ? "" : ", ") + kind;
  const toml::node* node = table.get("kind");
  if (node == nullptr) refuse(place, table, "kind", "is missing, expected one of " + all);
  const std::string kind = text(place, *node, "kind");
  const EffectWord* word = find_effect_word(kind);
  if (word == nullptr || word->place != where) {
    const std::string near = nearest_word(kind, kinds);
    refuse(
        place, *node, "kind",
        "is \"" + kind + "\", " + (near.empty() ? "" : "did you mean \"" + near + "\"? ") + "expected one of " + all);
  }
  return *word;
}

Effect read_effect(const Place& place, const toml::table& table, EffectPlace where, bool rotating) {
  const EffectWord& word = read_kind(place, table, where);
  Effect effect;
  effect.kind = word.kind;
  std::vector<std::string> known = {"kind", "coefficient"};
  std::vector<std::string> shapes;
  for (int i = 0; i < 2; ++i)
    if (const std::string key = shape_key(word, i, rotating); !key.empty()) shapes.push_back(key);
  known.insert(known.end(), shapes.begin(), shapes.end());
  require_known_keys(place, table, known);
  const toml::node* coefficient = table.get("coefficient");
  if (coefficient == nullptr)
    refuse(place, table, "coefficient",
           std::string("is missing, expected a number in ") + (rotating ? word.rotating_unit : word.unit) +
               " or \"estimate\"");
  effect.coefficient = read_coefficient(place, *coefficient, "coefficient", true);
  if (!word.in_core && effect.coefficient.estimate)
    refuse(place, *coefficient, "coefficient",
           "is \"estimate\", but the core cannot estimate " + effect.kind + ", expected a number");
  for (const std::string& key : shapes) {
    const toml::node* node = table.get(key);
    if (node == nullptr && word.shape_may_be_left_out) continue;
    if (node == nullptr) refuse(place, table, key, "is missing, expected a number above 0");
    effect.shape[key] = finite_number(place, *node, key);
    const bool zero_allowed = key == "damping_ratio";
    if (effect.shape[key] < 0.0 || (effect.shape[key] == 0.0 && !zero_allowed))
      refuse(place, *node, key,
             zero_allowed ? "is negative, expected 0 or more" : "is not above 0, expected a number above 0");
  }
  return effect;
}

}  // namespace

Coefficient read_coefficient(const Place& place, const toml::node& node, std::string_view key, bool may_be_negative) {
  Coefficient coefficient;
  if (node.is_string()) {
    const std::string word = node.value_or(std::string());
    if (word != "estimate") refuse(place, node, key, "is \"" + word + "\", expected a number or \"estimate\"");
    coefficient.estimate = true;
    return coefficient;
  }
  coefficient.value = finite_number(place, node, key);
  if (coefficient.value < 0.0 && !may_be_negative)
    refuse(place, node, key, "is negative, expected 0 or more, or \"estimate\"");
  return coefficient;
}

std::vector<Effect> read_effects(const Place& parent, const toml::table& table, EffectPlace where, bool rotating) {
  std::vector<Effect> effects;
  for (const toml::table* element : table_array(parent, table, "effect")) {
    const Place place{parent.file, parent.what + ", effect " + std::to_string(effects.size() + 1)};
    effects.push_back(read_effect(place, *element, where, rotating));
    for (size_t i = 0; i + 1 < effects.size(); ++i)
      if (effects[i].kind == effects.back().kind)
        refuse(place, *element->get("kind"), "kind", "repeats an earlier effect, expected each once");
  }
  return effects;
}

}  // namespace rig_file
