#include "hal/rig_file/toml/effect_words.hpp"

namespace rig_file {

using firmware::kEffectTable;

bool stands_on(const EffectRow& row, EffectPlace where) {
  if (row.written.as != firmware::RigFileForm::As::kEffectTable) return false;
  return row.place == where || (row.place == EffectPlace::kForceChannel && where == EffectPlace::kDof);
}

std::vector<const EffectRow*> effect_rows(EffectPlace where) {
  std::vector<const EffectRow*> rows;
  for (const EffectRow& row : kEffectTable)
    if (stands_on(row, where)) rows.push_back(&row);
  return rows;
}

const EffectRow* find_effect_row(const std::string& kind) {
  const EffectRow* row = firmware::find_effect(kind.c_str());
  return row != nullptr && row->written.as == firmware::RigFileForm::As::kEffectTable ? row : nullptr;
}

std::string unit_suffix(const std::string& unit) {
  if (unit.empty() || unit == "1") return "";
  std::string suffix = "_";
  for (const char c : unit)
    if (c != '^') suffix += c == ' ' || c == '/' ? '_' : c;
  return suffix;
}

std::string unit_of(const EffectRow& row, bool rotating) {
  return row.unit.of(rotating || row.unit.translating == nullptr);
}

std::string own_key(const EffectRow& row, bool rotating) {
  const char* unit = row.unit.of(rotating);
  if (row.written.as != firmware::RigFileForm::As::kKey || unit == nullptr) return "";
  const char* word = rotating && row.written.rotating_key != nullptr ? row.written.rotating_key : row.written.key;
  return word + unit_suffix(unit);
}

std::string shape_key(const EffectRow& row, int index, bool rotating) {
  if (index >= row.shape.count) return "";
  return row.shape.at[index].key + unit_suffix(row.shape.at[index].unit.of(rotating));
}

double shape_of(const Effect& effect, int index, bool rotating) {
  const EffectRow* row = find_effect_row(effect.kind);
  if (row == nullptr) return 0.0;
  const auto found = effect.shape.find(shape_key(*row, index, rotating));
  return found == effect.shape.end() ? 0.0 : found->second;
}

bool in_core(const Effect& effect, bool rotating) {
  const EffectRow* row = find_effect_row(effect.kind);
  if (row == nullptr || !row->core.estimable) return false;
  for (int i = 0; i < row->shape.count; ++i)
    if (!row->shape.at[i].in_core && shape_of(effect, i, rotating) != 0.0) return false;
  return true;
}

}  // namespace rig_file
