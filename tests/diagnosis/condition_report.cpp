// Blind draws under every condition of the hidden-rig generator, and what the diagnosis says of them.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "condition_tally.hpp"

namespace {

using hidden_rig::Said;

constexpr const char* kSensors[] = {"xva", "xa", "x", "a", "v", "mixed"};

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Diagnoses blind draws under every condition and counts what is right");
  int draws = 3;
  uint64_t first_seed = 1;
  std::vector<std::string> only;
  std::string sensors, effect, hidden = "both";
  app.add_option("--draws", draws, "with nothing hidden and as many with one effect, per condition");
  app.add_option("--first-seed", first_seed, "of the first draw");
  app.add_option("--conditions", only, "only these, comma between")->delimiter(',');
  app.add_option("--sensors", sensors, "only these: xva, xa, x, a, v or mixed");
  app.add_option("--hidden", hidden, "both, nothing or one");
  app.add_option("--effect", effect, "only this word is hidden");
  CLI11_PARSE(app, argc, argv);
  std::vector<Said> all;
  for (const hidden_rig::Condition& c : hidden_rig::conditions()) {
    if (!only.empty() && std::find(only.begin(), only.end(), c.name) == only.end()) continue;
    const size_t place = static_cast<size_t>(&c - hidden_rig::conditions().data());
    for (int i = 0; i < draws; ++i)
      for (const bool hides : {false, true}) {
        if (hidden == (hides ? "nothing" : "one")) continue;
        const size_t turn = (static_cast<size_t>(i) + place) % std::size(kSensors);
        const uint64_t seed = first_seed + static_cast<uint64_t>(i) + 100000 * place;
        try {
          all.push_back(hidden_rig::ask(c.name, sensors.empty() ? kSensors[turn] : sensors, hides, seed, effect));
        } catch (const std::runtime_error& e) {
          std::cerr << c.name << " seed " << seed << ": " << e.what() << "\n";
          continue;
        }
        const Said& s = all.back();
        std::cout << outcome_word(s.outcome) << " " << s.condition << " " << s.sensors << " " << s.seed << " " << s.text
                  << " (" << s.seconds << " s)\n"
                  << std::flush;
      }
  }
  write_table(std::cout, all);
  return 0;
} catch (const std::exception& e) {
  std::cerr << "condition_report: " << e.what() << "\n";
  return 2;
}
