// How often a number goes out VALID and wrong, and how often a right model is accused: counts over draws of tests/hidden_rig.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "record_outcome.hpp"
#include "tests/hidden_rig/conditions.hpp"

namespace {

using warrant_test::RecordOutcome;

struct Count {
  int records = 0, refused = 0, bent = 0, wrong = 0, suspect = 0, named = 0, placed = 0, misnamed = 0, nearest = 0;
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
    const bool told = o.suspect && o.is_cause;
    named += told && o.named == o.hidden;
    placed += told && o.named == o.hidden && o.named_where == o.where;
    misnamed += told && o.named != o.hidden;
    nearest += o.suspect && !o.is_cause && o.named == o.hidden;  // the right cause, not named
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
      "%-34s records %3d bent %3d WRONG %3d suspect %3d named %3d placed %3d misnamed %3d right but nearest %3d | "
      "valid %3.0f held %3.0f "
      "measurable %3.0f of them valid %3.0f%s\n",
      name.c_str(), c.records, c.bent, c.wrong, c.suspect, c.named, c.placed, c.misnamed, c.nearest,
      percent(c.valid, c.coefficients), percent(c.held, c.valid), percent(c.measurable, c.coefficients),
      percent(c.measurable_valid, c.measurable), c.refused ? " (refused some)" : "");
  std::fflush(stdout);
}

const char* const kSets[] = {"xva", "xa", "x", "a"};
constexpr uint64_t kFirstHidden = 20000, kFirstRight = 30000;

Count counted(const std::string& condition, const std::string& sensors, const std::string& hidden, uint64_t first,
              int draws) {
  hidden_rig::Settings settings;
  settings.condition = condition;
  settings.sensors = sensors;
  settings.hidden = hidden;
  Count count;
  for (int d = 0; d < draws; ++d) count.add(warrant_test::outcome_of(first + static_cast<uint64_t>(d), settings));
  return count;
}

std::string row(const std::string& name, const Count& c) {
  char text[160];
  std::snprintf(text, sizeof text, "| %s | %d | %d | %d | %d | %d | %d |\n", name.c_str(), c.records, c.bent, c.wrong,
                c.suspect, c.named, c.misnamed);
  return text;
}

std::string hidden_table(int draws) {
  std::string text =
      "One effect or sensor fault of the whole vocabulary is hidden, its force 0.05 to 0.6 of the damping force of its "
      "link.\n\"Bent\" are records with a coefficient over 5 % and over four quoted deviations off; \"VALID and "
      "wrong\" "
      "those where such a\ncoefficient goes out VALID.\n\n| sensors, noise | records | bent | VALID and wrong | "
      "withdrawn | cause named right | another cause named |\n|---|---|---|---|---|---|---|\n";
  for (const char* condition : {"random_1pct", "random_5pct"})
    for (const char* set : kSets) {
      const Count c = counted(condition, set, "any", kFirstHidden, draws);
      const std::string line = row(std::string(set) + ", " + condition, c);
      std::printf("%s", line.c_str());
      text += line;
      std::fflush(stdout);
    }
  return text;
}

std::string right_table(int draws) {
  std::string text =
      "\nNothing is hidden. A cell: records called suspect of all; of the coefficients that the record can measure "
      "within "
      "5 %,\nhow many percent are VALID; how many percent of the intervals of VALID numbers hold the truth; in bold "
      "the "
      "records with\na number that is VALID and wrong.\n\n| condition | xva | xa | x | a |\n|---|---|---|---|---|\n";
  for (const hidden_rig::Condition& condition : hidden_rig::conditions()) {
    std::string line = "| " + condition.name + " |";
    for (const char* set : kSets) {
      const Count c = counted(condition.name, set, "none", kFirstRight, draws);
      char cell[120];
      std::snprintf(cell, sizeof cell, " %d of %d, %.0f, %.0f%s |", c.suspect, c.records,
                    percent(c.measurable_valid, c.measurable), percent(c.held, c.valid),
                    c.wrong == 0 ? "" : (", **" + std::to_string(c.wrong) + "**").c_str());
      line += cell;
    }
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
    text += line + "\n";
  }
  return text;
}

// Replaces what follows the heading.
void write_page(const std::string& page, int draws) {
  static const std::string kHeading = "## Measured\n";
  std::ifstream in(page, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const size_t at = text.find(kHeading);
  if (at == std::string::npos) throw std::runtime_error(page + " has no heading " + kHeading);
  text = text.substr(0, at) + kHeading +
         "\nWritten by `build/host/bin/warrant_bench --page docs/warrant.md` (`tests/run.sh "
         "--bench`), " +
         std::to_string(draws) +
         " rigs for each row of the first table\nand a tenth of that for each cell "
         "of the second, drawn by `tests/hidden_rig`; seeds from " +
         std::to_string(kFirstHidden) + " and " + std::to_string(kFirstRight) + ".\n\n" + hidden_table(draws) +
         right_table(std::max(1, draws / 10));
  std::ofstream out(page, std::ios::binary);
  if (!(out << text).flush()) throw std::runtime_error(page + " cannot be written");
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("VALID and wrong, and right models accused, over drawn rigs");
  std::vector<std::string> names = {"random_1pct"}, sensors = {"xva", "xa", "x", "a"};
  hidden_rig::Settings settings;
  uint64_t first = 1;
  int draws = 20;
  bool tell = false;
  std::string page;
  uint16_t budget = 65535;
  app.add_option("--condition", names, "conditions; all");
  app.add_option("--sensors", sensors, "sensor sets");
  app.add_option("--hidden", settings.hidden, "an effect, any, two or none");
  app.add_option("--masses", settings.masses, "how many; 0: as the condition draws");
  app.add_option("--fault", settings.fault, "strength of a channel's fault: seconds late, relative gain; 0: drawn");
  app.add_option("--first", first, "first seed");
  app.add_option("--draws", draws, "rigs per condition and sensor set");
  app.add_option("--budget", budget, "probe_products_per_sample; 65535: all, 65534: a board's default");
  app.add_flag("--tell", tell, "every record");
  app.add_option("--page", page, "Markdown page whose part below \"## Measured\" is written anew, from --draws");
  CLI11_PARSE(app, argc, argv);
  if (!page.empty()) {
    write_page(page, draws);
    return 0;
  }
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
        const RecordOutcome o = warrant_test::outcome_of(first + static_cast<uint64_t>(d), settings, budget);
        if (tell) std::printf("%s %s %s", set.c_str(), name.c_str(), warrant_test::describe(o).c_str());
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
