#include "host_sim/vocabulary/effects_page.hpp"

#include <sstream>

#include "hal/rig_file/toml/effect_words.hpp"

namespace vocabulary {
namespace {

using firmware::EffectRow;
using firmware::kEffectTable;

const std::string kBegin = "<!-- generated from firmware/vocabulary by vocabulary_page: ";
const std::string kEnd = "<!-- end of the generated part -->\n";

std::string cell(const std::string& text) {  // a bar would end it
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string both_units(const firmware::Unit& unit) {
  if (unit.translating == nullptr) return unit.rotating;
  const std::string translating = unit.translating, rotating = unit.rotating;
  if (translating == "channel") return "the channel's";
  return translating == rotating ? translating : translating + " (" + rotating + ")";
}

std::string keys(const EffectRow& row) {
  std::string text;
  for (int i = 0; i < row.shape.count; ++i)
    text += (text.empty() ? "`" : ", `") + rig_file::shape_key(row, i, row.unit.translating == nullptr) + "`" +
            (row.shape.at[i].may_be_left_out ? " (may be left out)" : "");
  return text;
}

const char* place_word(const EffectRow& row) {
  switch (row.place) {
    case firmware::EffectPlace::kDof:
      return "DOF";
    case firmware::EffectPlace::kLink:
      return "link";
    case firmware::EffectPlace::kChannel:
      return "channel";
    case firmware::EffectPlace::kForceChannel:
      break;
  }
  return "force channel";
}

const char* table_word(const EffectRow& row) { return row.place == firmware::EffectPlace::kLink ? "link" : "dof"; }

}  // namespace

std::string rig_file_table() {
  std::ostringstream out;
  out << "| kind | table | force with coefficient q | q in (rotating) | further keys |\n|---|---|---|---|---|\n";
  for (const EffectRow& row : kEffectTable) {
    if (row.written.as != firmware::RigFileForm::As::kEffectTable) continue;
    out << "| `" << row.word.text << "` | `[[" << table_word(row) << ".effect]]` | " << cell(row.formula.text) << " | "
        << both_units(row.unit) << " | " << keys(row) << " |\n";
  }
  return out.str();
}

std::string effects_table() {
  std::ostringstream out;
  out << "| word | on a | what it is | the core estimates it | CAN | what sets it apart |\n|---|---|---|---|---|---|\n";
  for (const EffectRow& row : kEffectTable) {
    if (row.role == firmware::EffectRole::kOwnTerm) continue;
    out << "| `" << row.word.text << "` | " << place_word(row) << " | " << cell(row.sentence.text) << " | "
        << (row.core.estimable ? "yes" : "no") << " | " << static_cast<int>(row.can.number) << " | "
        << cell(row.experiment.text) << " |\n";
  }
  return out.str();
}

std::string renewed_page(const std::string& page) {
  std::string result;
  size_t at = 0;
  for (size_t begin = page.find(kBegin); begin != std::string::npos; begin = page.find(kBegin, at)) {
    const size_t line_end = page.find('\n', begin), end = page.find(kEnd, begin);
    if (line_end == std::string::npos || end == std::string::npos) return "";
    const std::string name =
        page.substr(begin + kBegin.size(), page.find(' ', begin + kBegin.size()) - begin - kBegin.size());
    if (name != "rig_file_table" && name != "effects_table") return "";
    result += page.substr(at, line_end + 1 - at) + "\n" +
              (name == "rig_file_table" ? rig_file_table() : effects_table()) + "\n" + kEnd;
    at = end + kEnd.size();
  }
  return at == 0 ? "" : result + page.substr(at);
}

}  // namespace vocabulary
