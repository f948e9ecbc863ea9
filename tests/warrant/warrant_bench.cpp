// How often a number goes out VALID and wrong, and how often a right model is accused: counts over draws of tests/hidden_rig.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "record_outcome.hpp"
#include "tests/hidden_rig/conditions.hpp"

namespace {

using warrant_test::RecordOutcome;

struct Count {
  int records = 0, refused = 0, bent = 0, wrong = 0, suspect = 0, named = 0, placed = 0;
  int coefficients = 0, valid = 0, held = 0, measurable = 0, measurable_valid = 0;
  void add(const RecordOutcome& o) {
    if (o.refused) {
      ++refused;
      return;
    }
    ++records;
    bent += o.bent();
    wrong += o.valid_and_wrong();
    suspect += o.suspect;
    named += o.suspect && o.named == o.hidden;
    placed += o.suspect && o.named == o.hidden && o.named_where == o.where;
    for (const auto& c : o.coefficients) {
      ++coefficients;
      valid += c.valid();
      held += c.valid() && c.held;
      measurable += c.measurable;
      measurable_valid += c.measurable && c.valid();
    }
  }
};

double percent(int part, int whole) { return whole == 0 ? 0.0 : 100.0 * part / whole; }

void print(const std::string& name, const Count& c) {
  std::printf(
      "%-34s records %3d bent %3d WRONG %3d suspect %3d named %3d placed %3d | valid %3.0f held %3.0f "
      "measurable %3.0f of them valid %3.0f%s\n",
      name.c_str(), c.records, c.bent, c.wrong, c.suspect, c.named, c.placed, percent(c.valid, c.coefficients),
      percent(c.held, c.valid), percent(c.measurable, c.coefficients), percent(c.measurable_valid, c.measurable),
      c.refused ? " (refused some)" : "");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("VALID and wrong, and right models accused, over drawn rigs");
  std::vector<std::string> names = {"random_1pct"}, sensors = {"xva", "xa", "x", "a"};
  hidden_rig::Settings settings;
  uint64_t first = 1;
  int draws = 20;
  bool tell = false;
  unsigned budget = 65535;
  app.add_option("--condition", names, "conditions; all");
  app.add_option("--sensors", sensors, "sensor sets");
  app.add_option("--hidden", settings.hidden, "an effect, any, two or none");
  app.add_option("--masses", settings.masses, "how many; 0: as the condition draws");
  app.add_option("--first", first, "first seed");
  app.add_option("--draws", draws, "rigs per condition and sensor set");
  app.add_option("--budget", budget, "probe_products_per_sample");
  app.add_flag("--tell", tell, "every record");
  CLI11_PARSE(app, argc, argv);
  if (names.size() == 1 && names[0] == "all") {
    names.clear();
    for (const hidden_rig::Condition& c : hidden_rig::conditions()) names.push_back(c.name);
  }
  for (const std::string& set : sensors) {
    Count all;
    std::map<std::string, Count> of_effect;
    for (const std::string& name : names) {
      Count count;
      settings.condition = name;
      settings.sensors = set;
      for (int d = 0; d < draws; ++d) {
        const RecordOutcome o =
            warrant_test::outcome_of(first + static_cast<uint64_t>(d), settings, static_cast<uint16_t>(budget));
        if (tell) std::printf("%s", warrant_test::describe(o).c_str());
        count.add(o);
        all.add(o);
        of_effect[o.hidden].add(o);
      }
      print(set + " " + name, count);
    }
    if (settings.hidden == "any")
      for (const auto& [effect, count] : of_effect) print("  " + set + " " + effect, count);
    print(set + " all", all);
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "warrant_bench: %s\n", e.what());
  return 2;
}
