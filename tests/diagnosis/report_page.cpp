// docs/diagnosis.md from the tallies.
#include <algorithm>
#include <cstdio>
#include <ostream>

#include "report_lines.hpp"

namespace hidden {
namespace {

// The marks: smallest strength named in 95 %, rho in percent at 1 % and at 5 % noise; faults of motion channels: us, %, % of
// the channel's rms.
struct Limit {
  const char* effect;
  double at_1, at_5;
};
constexpr Limit kMarks[] = {{"cubic_stiffness", 0.21, 1.05},
                            {"stiffness_error", 0.28, 1.4},
                            {"asymmetric_viscous", 0.29, 1.45},
                            {"quadratic_stiffness", 0.30, 1.55},
                            {"end_stop", 0.37, 1.9},
                            {"drifting_viscous", 0.38, 1.9},
                            {"missing_viscous", 0.39, 1.9},
                            {"mass_error", 0.43, 2.2},
                            {"backlash", 0.4, 2.0},
                            {"displacement_dependent_damping", 0.63, 3.1},
                            {"unmodelled_resonance", 0.66, 3.3},
                            {"missing_coulomb", 0.82, 4.0},
                            {"cubic_damping", 0.94, 4.6},
                            {"force_offset", 1.3, 6.5},
                            {"quadratic_damping", 1.4, 6.8},
                            {"stribeck", 1.6, 8.3},
                            {"sensor_delay of motion", 9.8, 48},
                            {"sensor_gain of motion", 0.07, 0.36},
                            {"mains_hum of motion", 0.07, 0.36}};

template <typename... Values>
void put(std::ostream& out, const char* format, Values... values) {
  char text[1200];
  std::snprintf(text, sizeof text, format, values...);
  out << text;
}

void table(std::ostream& out, const std::vector<Line>& lines, const std::vector<Tally>& tallies) {
  out << "| hidden | draws | exact | in a set | wrong | mark | | mean CPU s | slowest "
         "|\n|---|---|---|---|---|---|---|---|---|\n";
  for (size_t i = 0; i < lines.size(); ++i) {
    const Tally& t = tallies[i];
    const double exact = 100.0 * t.exact / t.draws, set = 100.0 * t.set / t.draws;
    const double counted = exact + (lines[i].sets_count ? std::min(set, 10.0) : 0);
    put(out, "| %s | %d | %.1f %% | %.1f %% | %.1f %% | ", lines[i].title.c_str(), t.draws, exact, set,
        100 - exact - set);
    if (lines[i].mark_percent > 0)
      put(out, "%.0f %% | %s", lines[i].mark_percent, counted >= lines[i].mark_percent ? "passed" : "**missed**");
    else
      out << " | ";
    put(out, " | %.2f | %.2f |\n", t.seconds / t.draws, t.slowest);
  }
}

void limits(std::ostream& out, const std::vector<Line>& lines, const std::vector<Tally>& tallies) {
  const Tally *low = nullptr, *high = nullptr;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].title == "nothing, 1 % noise") low = &tallies[i];
    if (lines[i].title == "nothing, 5 % noise") high = &tallies[i];
  }
  if (!low || !high) return;
  out << "\n## What would have been seen\n\nThe strengths that every \"none\" prints, rms of the hidden force in "
         "percent of its link's damping "
         "force: median over all places in the draws\nabove in which nothing was hidden, beside the mark. Faults \"of "
         "motion\" are those of a displacement, velocity or acceleration channel:\ndelay in us, gain error in percent, "
         "hum in percent of the channel's rms.\n\n"
         "| effect | 1 % noise | mark | 5 % noise | mark |\n|---|---|---|---|---|\n";
  for (const Limit& m : kMarks) {
    const auto median = [&](const Tally* t) {
      return t->limits.count(m.effect) ? quantile(t->limits.at(m.effect), 0.5) : 0.0;
    };
    if (median(low) > 0)
      put(out, "| `%s` | %.2f | %.2f | %.2f | %.2f |\n", m.effect, median(low), m.at_1, median(high), m.at_5);
  }
}

}  // namespace

void write_page(std::ostream& out, const std::vector<Line>& lines, const std::vector<Tally>& tallies, uint64_t seed) {
  int draws = 0;
  for (const Tally& t : tallies) draws += t.draws;
  put(out,
      "# What the diagnosis finds\n\nWritten by `build/host/bin/diagnosis_report docs/diagnosis.md` (`--share 0.1`: a "
      "tenth of the draws): %d draws of chains of one to four masses, "
      "force of 5 to 50 Hz on DOF 1,\n20 s at 1 kHz. The seeds of every line count from %llu; none is left out. "
      "Strength of an effect: rms of its "
      "force 0.05 to 0.6 of that of its\nlink's damping. *Exact*: every hidden effect by name and place and nothing "
      "else. *In a set*: named as one of "
      "several that fit equally;\nthis counts in up to a tenth of the draws. CPU time is of one core and a whole "
      "diagnosis. Few draws prove little: 29 of 29 means "
      "over 90 %% in\n19 of 20 cases, 200 of 200 over 98.5 %%.\n\n",
      draws, static_cast<unsigned long long>(seed));
  table(out, lines, tallies);
  out << "\n## Gain on unseen data\n\nNRMSE of the free run on the last 30 % of the record: true model (right terms "
         "and shapes, coefficients fitted) over "
         "the extended one, for\nevery fourth exact answer whose effect a rig file can state. 1: as good as the truth; "
         "the mark is 0.9.\n\n"
         "| hidden | compared | median | 5 % are below |\n|---|---|---|---|\n";
  for (size_t i = 0; i < lines.size(); ++i)
    if (!tallies[i].gain_shares.empty())
      put(out, "| %s | %zu | %.3f | %.3f |\n", lines[i].title.c_str(), tallies[i].gain_shares.size(),
          quantile(tallies[i].gain_shares, 0.5), quantile(tallies[i].gain_shares, 0.05));
  limits(out, lines, tallies);
  out << "\n## Confusion and power\n";
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].settings.hide != Hide::kOne || lines[i].settings.sensors != "xva" || lines[i].settings.dofs ||
        lines[i].settings.drive != Drive::kSmooth)
      continue;
    out << "\n### " << lines[i].title << "\n\n| hidden | said (times) |\n|---|---|\n";
    for (const auto& row : tallies[i].confusion) {
      out << "| `" << row.first << "` |";
      for (const auto& cell : row.second) out << " " << cell.first << " " << cell.second << ";";
      out << " |\n";
    }
    out << "\nFound, by strength: ";
    for (const auto& bin : tallies[i].power)
      put(out, "%.1f to %.1f: %d of %d; ", bin.first * 0.1, bin.first * 0.1 + 0.1, bin.second.first, bin.second.second);
    out << "\n";
  }
  out << "\n## Every answer that was not exact\n";
  for (size_t i = 0; i < lines.size(); ++i) {
    if (tallies[i].misses.empty() || lines[i].mark_percent <= 0) continue;
    out << "\n### " << lines[i].title << "\n\n";
    for (const std::string& miss : tallies[i].misses) out << "- " << miss << "\n";
  }
}

}  // namespace hidden
