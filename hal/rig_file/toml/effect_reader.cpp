#include "hal/rig_file/toml/effect_reader.hpp"

namespace rig_file {
namespace {

const EffectRow& read_kind(const Place& place, const toml::table& table, EffectPlace where) {
  std::vector<std::string> kinds;
  for (const EffectRow* row : effect_rows(where)) kinds.emplace_back(row->word.text);
  std::string all;
  for (const std::string& kind : kinds) all += (all.empty() ? "" : ", ") + kind;
  const toml::node* node = table.get("kind");
  if (node == nullptr) refuse(place, table, "kind", "is missing, expected one of " + all);
  const std::string kind = text(place, *node, "kind");
  const EffectRow* row = find_effect_row(kind);
  if (row == nullptr || !stands_on(*row, where)) {
    const std::string near = nearest_word(kind, kinds);
    refuse(
        place, *node, "kind",
        "is \"" + kind + "\", " + (near.empty() ? "" : "did you mean \"" + near + "\"? ") + "expected one of " + all);
  }
  return *row;
}

void read_shapes(const Place& place, const toml::table& table, const EffectRow& row, bool rotating, Effect& effect) {
  for (int i = 0; i < row.shape.count; ++i) {
    const firmware::ShapeParameter& parameter = row.shape.at[i];
    const std::string key = shape_key(row, i, rotating);
    const toml::node* node = table.get(key);
    if (node == nullptr && parameter.may_be_left_out) continue;
    if (node == nullptr) refuse(place, table, key, "is missing, expected a number above 0");
    const double value = effect.shape[key] = finite_number(place, *node, key);
    if (value < 0.0 || (value == 0.0 && !parameter.zero_allowed))
      refuse(place, *node, key,
             parameter.zero_allowed ? "is negative, expected 0 or more" : "is not above 0, expected a number above 0");
    if (value != 0.0 && !parameter.in_core && row.core.estimable && effect.coefficient.estimate)
      refuse(place, *node, key,
             "stands beside coefficient = \"estimate\", but the core cannot estimate " + effect.kind +
                 " with it, expected a number as coefficient");
  }
}

Effect read_effect(const Place& place, const toml::table& table, EffectPlace where, bool rotating) {
  const EffectRow& row = read_kind(place, table, where);
  Effect effect;
  effect.kind = row.word.text;
  if (row.unit.of(rotating) == nullptr)
    refuse(place, *table.get("kind"), "kind",
           "is \"" + effect.kind + "\", which stands on " + (rotating ? "translating" : "rotating") + " links alone");
  std::vector<std::string> known = {"kind", "coefficient"};
  for (int i = 0; i < row.shape.count; ++i) known.push_back(shape_key(row, i, rotating));
  require_known_keys(place, table, known);
  const toml::node* coefficient = table.get("coefficient");
  const std::string expected = row.core.estimable ? " or \"estimate\"" : "";
  if (coefficient == nullptr)
    refuse(place, table, "coefficient", "is missing, expected a number in " + unit_of(row, rotating) + expected);
  effect.coefficient = read_coefficient(place, *coefficient, "coefficient", true);
  if (!row.core.estimable && effect.coefficient.estimate)
    refuse(place, *coefficient, "coefficient",
           "is \"estimate\", but the core cannot estimate " + effect.kind + ", expected a number");
  read_shapes(place, table, row, rotating, effect);
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
