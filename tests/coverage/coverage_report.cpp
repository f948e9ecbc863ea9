// Writes docs/coverage.md: what goes out VALID and whether its intervals hold, by condition and sensor set.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "tally.hpp"
#include "tests/hidden_rig/conditions.hpp"

namespace {

struct Arguments {
  int draws = 8;
  uint64_t first = 1000;
  std::vector<std::string> conditions, sensors = {"xva", "xa", "x", "a", "v"};
  bool tell = false;
  std::string page;
};

std::string cell(const coverage::Tally& t) {
  char text[80];
  if (t.coefficients == 0) return " - |";
  if (t.valid == 0)
    std::snprintf(text, sizeof text, " 0, - |");
  else
    std::snprintf(text, sizeof text, " %.0f, %.0f%s |", t.valid_percent(), t.held_percent(),
                  t.wrong == 0 ? "" : (", **" + std::to_string(t.wrong) + "**").c_str());
  return text;
}

std::string heading(const Arguments& a) {
  std::string text =
      "# Do the intervals hold?\n\nWritten by `build/host/bin/coverage_report docs/coverage.md` (`tests/run.sh "
      "--bench`). "
      "Rigs are drawn by `tests/hidden_rig`,\nnothing is hidden in them; seeds " +
      std::to_string(a.first) + " to " + std::to_string(a.first + static_cast<uint64_t>(a.draws) - 1) +
      ", the same for every condition and sensor set. A cell says how many percent of the\ncoefficients go out VALID, "
      "how many percent of their 95 % intervals hold the truth and, in bold, how many are wrong: VALID, over\n5 % and "
      "over four quoted standard deviations off.\n\n| condition |";
  for (const std::string& s : a.sensors) text += " " + s + " |";
  text += "\n|---|";
  for (size_t i = 0; i < a.sensors.size(); ++i) text += "---|";
  return text + "\n";
}

std::string measure(const Arguments& a) {
  std::string text = heading(a);
  std::vector<coverage::Tally> total(a.sensors.size());
  for (const std::string& condition : a.conditions) {
    std::string line = "| " + condition + " |";
    for (size_t s = 0; s < a.sensors.size(); ++s) {
      const coverage::Tally tally = coverage::count(condition, a.sensors[s], a.first, a.draws, a.tell);
      total[s].add(tally);
      line += cell(tally);
    }
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
    text += line + "\n";
  }
  std::string line = "| **all** |";
  for (const coverage::Tally& t : total) line += cell(t);
  std::printf("%s\n", line.c_str());
  return text + line + "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Coverage of 95 % intervals where nothing is hidden");
  Arguments arguments;
  app.add_option("page", arguments.page, "Markdown page to write; without it only the table is printed");
  app.add_option("--draws", arguments.draws, "rigs per condition and sensor set");
  app.add_option("--first", arguments.first, "first seed");
  app.add_option("--condition", arguments.conditions, "only these");
  app.add_option("--sensors", arguments.sensors, "only these sets");
  app.add_flag("--tell", arguments.tell, "a line for every coefficient");
  CLI11_PARSE(app, argc, argv);
  if (arguments.conditions.empty())
    for (const hidden_rig::Condition& c : hidden_rig::conditions()) arguments.conditions.push_back(c.name);
  const std::string page = measure(arguments);
  if (arguments.page.empty()) return 0;
  std::ofstream file(arguments.page, std::ios::binary);
  if (!(file << page).flush()) throw std::runtime_error(arguments.page + " cannot be written");
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "coverage_report: %s\n", e.what());
  return 2;
}
