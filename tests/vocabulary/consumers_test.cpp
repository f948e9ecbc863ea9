// Every effect in everybody who lists effects: whoever forgets one fails here. The diagnosis has the same walk beside its own
// tests; the core's laws are compared in core_laws_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/value_tables.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/effect_words.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/can_log/dbc.hpp"
#include "host_sim/can_log/known_names.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/vocabulary/effects_page.hpp"
#include "tests/vocabulary/typical_shape.hpp"

namespace {

using firmware::EffectPlace;
using firmware::EffectRole;
using firmware::EffectRow;
using firmware::kEffectTable;

// Motion of the forced pendulum or mass below: 0.3 m, 3 m/s, 1 s at 1 kHz under 40 N.
constexpr vocabulary_test::Scales kScales{0.3, 0.2, 2.0, 1.0, 1000.0, 40.0};

bool in_a_table(const EffectRow& row) { return row.written.as == firmware::RigFileForm::As::kEffectTable; }
bool rotates(const EffectRow& row) { return row.unit.translating == nullptr; }

// One DOF on a spring with a damper and friction; the row's effect with its shapes in the middle of their ranges.
std::string rig_text(const EffectRow& row, const std::string& coefficient, bool rotating, bool core_only) {
  std::ostringstream text;
  text << "schema = \"rig/1\"\nname = \"r\"\n[[dof]]\n" << (rotating ? "inertia_kg_m2" : "mass_kg") << " = 1.0\n";
  std::ostringstream effect;
  const vocabulary::Shape shape = vocabulary_test::typical_shape(row, kScales, core_only);
  effect << ".effect]]\nkind = \"" << row.word.text << "\"\ncoefficient = " << coefficient << "\n";
  for (int i = 0; i < row.shape.count; ++i)
    if (!core_only || row.shape.at[i].in_core)
      effect << rig_file::shape_key(row, i, rotating) << " = " << std::to_string(shape.p[i]) << "\n";
  const bool on_link = row.place == EffectPlace::kLink;
  if (!on_link) text << "[[dof" << effect.str();
  text << "[[link]]\nbetween = [1, 0]\n"
       << (rotating ? "stiffness_N_m_rad = 400.0\nviscous_N_m_s_rad = 2.0\ncoulomb_N_m = 1.0\n"
                    : "stiffness_N_m = 400.0\nviscous_N_s_m = 2.0\ncoulomb_N = 1.0\n");
  if (on_link) text << "[[link" << effect.str();
  return text.str();
}

rig_file::RigModel rig_with(const EffectRow& row, const std::string& coefficient, bool core_only = false) {
  return rig_file::parse_rig(rig_text(row, coefficient, rotates(row), core_only), "r.toml");
}

host_sim::Record forced(const rig_file::RigModel& rig) {
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(40.0, 2.5, -1.5707963267948966)};  // a sine: sets in smoothly
  return host_sim::simulate(rig, {}, excitation, {1e-3, 0, 0, 1000, 0.0});
}

std::string file_text(const char* name) {
  std::ostringstream text;
  text << std::ifstream(std::string(RIG_SOURCE_DIR) + name).rdbuf();
  return text.str();
}

}  // namespace

TEST(Consumers, RigFilesReadAndWriteEveryEffect) {
  int read = 0;
  for (const EffectRow& row : kEffectTable) {
    if (!in_a_table(row)) continue;
    SCOPED_TRACE(row.word.text);
    for (const bool rotating : {false, true}) {
      if (row.unit.of(rotating) == nullptr) {
        EXPECT_THROW(rig_file::parse_rig(rig_text(row, "1.5", rotating, false), ""), rig_file::RigFileError);
        continue;
      }
      const rig_file::RigModel rig = rig_file::parse_rig(rig_text(row, "1.5", rotating, false), "");
      const auto& effects = row.place == EffectPlace::kLink ? rig.links[0].effects : rig.dofs[0].effects;
      ASSERT_EQ(effects.size(), 1u);
      const rig_file::RigModel again = rig_file::parse_rig(rig_file::format_rig(rig), "");
      const auto& back = row.place == EffectPlace::kLink ? again.links[0].effects : again.dofs[0].effects;
      ASSERT_EQ(back.size(), 1u);
      EXPECT_EQ(back[0].kind, row.word.text);
      EXPECT_EQ(back[0].coefficient.value, 1.5);
      EXPECT_EQ(back[0].shape, effects[0].shape);
      EXPECT_EQ(back[0].shape.size(), static_cast<size_t>(row.shape.count));
    }
    ++read;
  }
  EXPECT_GE(read, 17);
}

// "estimate" where the core has a column, with the row's unit and name; a refusal that says so where it has none.
TEST(Consumers, TheCoreTakesWhatTheRowsSayItCan) {
  for (const EffectRow& row : kEffectTable) {
    if (!in_a_table(row)) continue;
    SCOPED_TRACE(row.word.text);
    if (!row.core.estimable) {
      EXPECT_THROW(rig_with(row, "\"estimate\"", true), rig_file::RigFileError);
      continue;
    }
    const auto table = rig_file::parameter_table(rig_with(row, "\"estimate\"", true));
    ASSERT_EQ(table.size(), 1u);
    EXPECT_EQ(table[0].kind, row.core.term);
    EXPECT_EQ(table[0].name.substr(0, table[0].name.find('[')), row.word.text);
    EXPECT_EQ(table[0].unit, row.unit.of(rotates(row)));
  }
}

TEST(Consumers, CanNamesEveryCauseAndEveryTerm) {
  std::ostringstream dbc;
  can_log::dbc(dbc);
  for (const EffectRow& row : kEffectTable) {
    SCOPED_TRACE(row.word.text);
    const std::string quoted = " \"" + std::string(row.word.text) + "\"";
    if (row.role != EffectRole::kOwnTerm) {
      bool named = false;
      for (const firmware::can::NamedValue& value : firmware::can::kCauses)
        named = named || (value.value == row.can.number && value.name == row.word.text);
      EXPECT_TRUE(named);
      EXPECT_NE(dbc.str().find(std::to_string(row.can.number) + quoted), std::string::npos);
    }
    if (!row.core.estimable || row.role == EffectRole::kCorrection) continue;
    EXPECT_EQ(std::string(firmware::can::kParameterKinds[static_cast<int>(row.core.term)].name), row.word.text);
    EXPECT_NE(dbc.str().find(std::to_string(static_cast<int>(row.core.term)) + quoted), std::string::npos);
    firmware::ParameterDescription description;
    description.kind = row.core.term, description.place_a = 1, description.place_b = 0;
    EXPECT_EQ(can_log::parameter_label(description), row.word.text + std::string("[1-0]"));
    EXPECT_EQ(can_log::parameter_unit(row.core.term, true), row.unit.rotating);
  }
}

// Every effect moves the plant, and the balance of forces takes it: with the true rig nothing is left of the record's second
// half (a balance that starts in the middle of a motion has to guess its memories), but for samples next to a change of sign.
TEST(Consumers, ThePlantMovesAndTheForcesBalance) {
  for (const EffectRow& row : kEffectTable) {
    if (!in_a_table(row)) continue;
    SCOPED_TRACE(row.word.text);
    const rig_file::RigModel rig = rig_with(row, row.role == EffectRole::kDriveFault ? "1.0" : "0.5");
    const host_sim::Record record = forced(rig);
    rig_file::RigModel without = rig;
    without.links[0].effects.clear(), without.dofs[0].effects.clear();
    const auto rms = [](const host_sim::Series& s) {
      double sum = 0.0;
      for (size_t i = s.size() / 2; i < s.size(); ++i) sum += s[i] * s[i];
      return std::sqrt(2.0 * sum / static_cast<double>(s.size()));
    };
    const double left = rms(host_sim::force_balance(rig, record).residual[0]);
    const double lacking = rms(host_sim::force_balance(without, record).residual[0]);
    EXPECT_GT(lacking, 1e-5);
    EXPECT_LT(left, 0.05 * lacking);
  }
}

TEST(Consumers, ThePagesAreWrittenFromTheRows) {
  for (const char* name : {"/docs/formats.md", "/docs/effects.md"}) {
    const std::string page = file_text(name);
    EXPECT_EQ(page, vocabulary::renewed_page(page)) << "renew it: build/host/bin/vocabulary_page docs" << (name + 5);
  }
  for (const EffectRow& row : kEffectTable)
    if (row.role != EffectRole::kOwnTerm) {
      EXPECT_NE(file_text("/docs/effects.md").find("| `" + std::string(row.word.text) + "` |"), std::string::npos);
    }
}
