#include <algorithm>
#include <cmath>

#include "firmware/configuration/capacity.hpp"
#include "host_sim/plant/scenario/scenario_parts.hpp"

namespace host_sim {
namespace {

using rig_file::Place;
using rig_file::refuse;

constexpr double kMostSamples = 2e7;

struct KindWord {
  LevelKind kind;
  const char* word;
  std::vector<std::string> keys;  // besides those that every level may have
};

const std::vector<KindWord>& kind_words() {
  static const std::vector<KindWord> words = {
      {LevelKind::kSine, "sine", {"dof", "amplitude_N", "frequency_Hz", "cycles", "settle_cycles"}},
      {LevelKind::kRandom, "random", {"dof", "rms_N", "band_Hz"}},
      {LevelKind::kFreeDecay, "free_decay", {}},
      {LevelKind::kBaseSine, "base_sine", {"amplitude_m", "frequency_Hz", "cycles", "settle_cycles"}},
  };
  return words;
}

const KindWord& read_kind(const Place& place, const toml::table& table) {
  const toml::node* node = table.get("kind");
  const std::string expected = "expected \"sine\", \"random\", \"free_decay\" or \"base_sine\"";
  if (node == nullptr) refuse(place, table, "kind", "is missing, " + expected);
  const std::string found = rig_file::text(place, *node, "kind");
  for (const KindWord& word : kind_words())
    if (found == word.word) return word;
  refuse(place, *node, "kind", "is \"" + found + "\", " + expected);
}

// One level's table, read key by key.
class LevelReader {
 public:
  LevelReader(const Place& place, const toml::table& table, const Scenario& scenario)
      : place_(place), table_(table), scenario_(scenario) {}

  ExcitationLevel read() {
    const KindWord& word = read_kind(place_, table_);
    level_.kind = word.kind;
    std::vector<std::string> known = {"kind", "settle_s", "duration_s", "displacement_m", "velocity_m_s"};
    known.insert(known.end(), word.keys.begin(), word.keys.end());
    rig_file::require_known_keys(place_, table_, known);
    if (const toml::node* dof = table_.get("dof"))
      level_.dof = static_cast<int>(
          rig_file::whole_number(place_, *dof, "dof", 1, static_cast<int64_t>(scenario_.rig.dofs.size())));
    switch (word.kind) {
      case LevelKind::kSine:
        read_sine("amplitude_N");
        break;
      case LevelKind::kBaseSine:
        read_base();
        break;
      case LevelKind::kRandom:
        read_random();
        break;
      case LevelKind::kFreeDecay:
        break;
    }
    read_lengths();
    level_.initial.x_m = read_state("displacement_m");
    level_.initial.v_m_s = read_state("velocity_m_s");
    if (word.kind == LevelKind::kFreeDecay) check_free_decay();
    return level_;
  }

 private:
  double number(const char* key, double least, const std::string& expected) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) refuse(place_, table_, key, "is missing, expected " + expected);
    return number_of(*node, key, least, expected);
  }
  // At least `least`; more than 0 where least is 0.
  double number_of(const toml::node& node, const char* key, double least, const std::string& expected) {
    const double value = rig_file::finite_number(place_, node, key);
    if (value < least || (least == 0.0 && value == 0.0))
      refuse(place_, node, key, "is " + std::to_string(value) + ", expected " + expected);
    return value;
  }
  double nyquist() const { return 0.5 * scenario_.sample_rate_Hz; }

  void read_sine(const char* amplitude_key) {
    level_.amplitude = number(amplitude_key, 0.0, "a number above 0");
    level_.frequency_Hz = number("frequency_Hz", 0.0, "a number above 0");
    if (level_.frequency_Hz >= nyquist())
      refuse(place_, *table_.get("frequency_Hz"), "frequency_Hz",
             "reaches half the sample rate, expected less than " + std::to_string(nyquist()));
  }
  void read_base() {
    read_sine("amplitude_m");
    const auto& links = scenario_.rig.links;
    if (std::none_of(links.begin(), links.end(), [](const rig_file::Link& link) { return link.b == rig_file::kBase; }))
      refuse(place_, *table_.get("kind"), "kind", "moves the base, expected a rig with a link between = [n, \"base\"]");
  }
  void read_random() {
    level_.rms_N = number("rms_N", 0.0, "a number above 0");
    const toml::node* node = table_.get("band_Hz");
    const std::string expected = "expected band_Hz = [low, high], 0 <= low < high < " + std::to_string(nyquist());
    if (node == nullptr) refuse(place_, table_, "band_Hz", "is missing, " + expected);
    const toml::array* band = node->as_array();
    if (band == nullptr || band->size() != 2) refuse(place_, *node, "band_Hz", "is not a pair, " + expected);
    level_.low_Hz = rig_file::finite_number(place_, (*band)[0], "band_Hz");
    level_.high_Hz = rig_file::finite_number(place_, (*band)[1], "band_Hz");
    if (level_.low_Hz < 0.0 || level_.low_Hz >= level_.high_Hz || level_.high_Hz >= nyquist())
      refuse(place_, *node, "band_Hz", "is not a band below half the sample rate, " + expected);
  }

  size_t samples(double seconds, const toml::node& node, const char* key) {
    const double count = seconds * scenario_.sample_rate_Hz;
    if (count > kMostSamples)
      refuse(place_, node, key, "is " + std::to_string(count) + " samples, expected at most 2e7");
    return static_cast<size_t>(std::llround(count));
  }
  // Seconds, or cycles of the level's frequency; false where neither key is there.
  bool read_length(const char* seconds_key, const char* cycles_key, double least, size_t& count) {
    const toml::node* seconds = table_.get(seconds_key);
    const toml::node* cycles = table_.get(cycles_key);
    if (seconds != nullptr && cycles != nullptr)
      refuse(place_, *cycles, cycles_key, std::string("stands beside ") + seconds_key + ", expected one of them");
    const std::string expected = least > 0.0 ? "a number above 0" : "0 or more";
    if (seconds != nullptr)
      count = samples(number_of(*seconds, seconds_key, least > 0.0 ? 0.0 : -1e-300, expected), *seconds, seconds_key);
    if (cycles != nullptr)
      count = samples(number_of(*cycles, cycles_key, least > 0.0 ? 0.0 : -1e-300, expected) / level_.frequency_Hz,
                      *cycles, cycles_key);
    return seconds != nullptr || cycles != nullptr;
  }
  void read_lengths() {
    if (!read_length("duration_s", "cycles", 1.0, level_.samples))
      refuse(
          place_, table_, "duration_s",
          std::string("is missing, expected the seconds to be measured") + (level_.periodic() ? " (or cycles)" : ""));
    read_length("settle_s", "settle_cycles", 0.0, level_.settle_samples);
    if (level_.samples < 8) refuse(place_, table_, "duration_s", "holds fewer than 8 sample periods, expected more");
  }

  std::vector<double> read_state(const char* key) {
    std::vector<double> values;
    const toml::node* node = table_.get(key);
    if (node == nullptr) return values;
    const size_t dofs = scenario_.rig.dofs.size();
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() != dofs)
      refuse(place_, *node, key, "is not a list of " + std::to_string(dofs) + " numbers, expected one for each DOF");
    for (const toml::node& value : *list) values.push_back(rig_file::finite_number(place_, value, key));
    return values;
  }
  void check_free_decay() {
    const auto moves = [](const std::vector<double>& v) {
      return std::any_of(v.begin(), v.end(), [](double x) { return x != 0.0; });
    };
    if (!moves(level_.initial.x_m) && !moves(level_.initial.v_m_s))
      refuse(place_, table_, "displacement_m", "is missing or all 0, expected the state that a free decay starts from");
    if (const toml::node* settle = table_.get("settle_s"); settle != nullptr && level_.settle_samples > 0)
      refuse(place_, *settle, "settle_s", "stands in a free decay, expected none: it is measured from its start");
  }

  const Place& place_;
  const toml::table& table_;
  const Scenario& scenario_;
  ExcitationLevel level_;
};

}  // namespace

void read_levels(const Place& top, const toml::table& root, Scenario& scenario) {
  for (const toml::table* table : rig_file::table_array(top, root, "level")) {
    const Place place{top.file, "level " + std::to_string(scenario.levels.size() + 1)};
    if (scenario.levels.size() == static_cast<size_t>(firmware::kMaxLevels))
      refuse(place, *table, "",
             "is one too many, expected at most " + std::to_string(firmware::kMaxLevels) + " levels");
    scenario.levels.push_back(LevelReader(place, *table, scenario).read());
  }
  if (scenario.levels.empty()) refuse(top, root, "level", "is missing, expected at least one [[level]]");
}

}  // namespace host_sim
