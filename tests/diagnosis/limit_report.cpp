// What the printed detection limits are worth: effects of half, once and twice the limit hidden in the very rig that printed it, under
// fresh noise.  limit_report [--draws N] [--first-seed S] [--sensors xva] [--out FILE]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "judgement.hpp"

namespace {

constexpr double kFaint = 1e-6;  // of the damping force: nothing shows
constexpr double kTimes[] = {0.5, 1, 2};
constexpr const char* kKinds[] = {"cubic_stiffness",
                                  "stiffness_error",
                                  "quadratic_damping",
                                  "cubic_damping",
                                  "asymmetric_viscous",
                                  "force_offset",
                                  "displacement_dependent_damping",
                                  "mass_error"};

// Of one kind: draws whose answer was "none" with a limit at the place where the effect would be, and how often it was found.
struct Row {
  int limits = 0, silent = 0, found[3] = {0, 0, 0};
  std::vector<double> percent;  // limits, of the damping force
};

bool named(const hidden::Hidden& truth, const diagnosis::Diagnosis& d) {
  const auto same = [&](const auto& o) { return o.effect == truth.effect && o.where == truth.where; };
  return std::any_of(d.causes.begin(), d.causes.end(), same) ||
         std::any_of(d.ambiguous_with.begin(), d.ambiguous_with.end(), same);
}

void measure(uint64_t seed, hidden::Settings settings, Row& row) {
  settings.rho_low = settings.rho_high = kFaint;
  const hidden::Draw faint = hidden::make_draw(seed, settings);
  const diagnosis::Diagnosis answer = hidden::answer_to(faint);
  const auto& limits = answer.minimum_detectable;
  const auto limit = std::find_if(limits.begin(), limits.end(), [&](const diagnosis::DetectionLimit& l) {
    return l.effect == faint.truth[0].effect && l.where == faint.truth[0].where;
  });
  if (answer.verdict != diagnosis::Verdict::kNone || limit == limits.end() || !(limit->percent_of_damping_force > 0) ||
      !(limit->percent_of_damping_force < 1e6)) {
    ++row.silent;
    return;
  }
  ++row.limits, row.percent.push_back(limit->percent_of_damping_force);
  // The strength is in proportion to the share: that of the faint one says how much a share is.
  const double share = kFaint * limit->strength / std::abs(faint.truth[0].strength);
  for (int i = 0; i < 3; ++i) {
    settings.rho_low = settings.rho_high = kTimes[i] * share;
    const hidden::Draw draw = hidden::make_draw(seed, settings);
    row.found[i] += named(draw.truth[0], hidden::answer_to(draw));
  }
}

std::string line_of(const char* kind, Row row) {
  std::sort(row.percent.begin(), row.percent.end());
  const double median = row.percent.empty() ? 0 : row.percent[row.percent.size() / 2];
  char text[200];
  std::snprintf(text, sizeof text, "| `%s` | %d | %d | %.2g | %d | %d | %d |\n", kind, row.limits, row.silent, median,
                row.found[0], row.found[1], row.found[2]);
  return text;
}

std::string page(int draws, uint64_t first_seed, const hidden::Settings& settings) {
  char text[1200];
  std::snprintf(
      text, sizeof text,
      "# Detection limits, measured\n\n"
      "With the answer `none` stands what would have been seen: the smallest strength of every effect at every place "
      "that both tests\nwould have named, the linear one on whole records and the simulations that have to bear it "
      "out. Each is meant to be seen in 95\nof 100 records; the page measures what that is worth.\n\n"
      "Written by `build/host/bin/limit_report --draws %d --first-seed %llu --out docs/detection_limits.md`: %d rigs "
      "for each effect,\nsensors %s, 1 %% noise, 20 s. Each rig answers with next to nothing hidden and says its "
      "limit; then with half of it, with the\nlimit and with twice the limit hidden in it. Found: named at its "
      "place, alone or in a set.\n\n",
      draws, static_cast<unsigned long long>(first_seed), draws, settings.sensors.c_str());
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measures detection limits: effects of half, once and twice the limit"};
  int draws = 10;
  uint64_t first_seed = 1;
  std::string out;
  hidden::Settings settings;
  app.add_option("--draws", draws, "rigs per effect");
  app.add_option("--first-seed", first_seed, "of the first rig");
  app.add_option("--sensors", settings.sensors, "xva, xa, x or a");
  app.add_option("--masses", settings.dofs, "0: one to three");
  app.add_option("--out", out, "file for the table; left out: the terminal");
  CLI11_PARSE(app, argc, argv);
  std::string text;
  Row all;
  for (const char* kind : kKinds) {
    settings.kind = kind;
    Row row;
    for (int i = 0; i < draws; ++i) measure(first_seed + static_cast<uint64_t>(i), settings, row);
    text += line_of(kind, row);
    all.limits += row.limits, all.silent += row.silent;
    for (int i = 0; i < 3; ++i) all.found[i] += row.found[i];
    all.percent.insert(all.percent.end(), row.percent.begin(), row.percent.end());
    std::fprintf(stderr, "%s", line_of(kind, row).c_str());
  }
  text =
      "| effect | rigs with a limit | without | median limit, % of the damping force | found at half | at the limit | "
      "at twice |\n|---|---|---|---|---|---|---|\n" +
      text + line_of("all", all);
  if (out.empty())
    std::printf("%s", text.c_str());
  else
    std::ofstream(out) << page(draws, first_seed, settings) << text;
  return 0;
}
