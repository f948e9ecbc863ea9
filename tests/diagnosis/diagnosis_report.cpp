// Many blind draws per class, and what the diagnosis says of them, as a Markdown page (docs/diagnosis.md).
//   diagnosis_report [--share S] [--first-seed S] [--jobs N] [--finished-only] FILE.md
// Every finished line is kept beside the page as FILE.md.partN: a run that was stopped goes on from there with the same
// options; --finished-only writes the page of the lines that are there and leaves them.
// or one line:  diagnosis_report line [key value ...]  (noise, n, seed, sensors, corner, bits, kind, low, high, hide,
// dofs, seconds, drive). Jobs are processes: a line is the unit of work.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "report_lines.hpp"

namespace {

using hidden::Hide;
using hidden::Line;
using hidden::Tally;

Hide hide_of(const std::string& v) {
  return v == "none"      ? Hide::kNothing
         : v == "two"     ? Hide::kTwo
         : v == "outside" ? Hide::kOutside
         : v == "fault"   ? Hide::kSensorFault
                          : Hide::kOne;
}

int one_line(int argc, char** argv) {
  Line line;
  line.draws = 20;
  uint64_t seed = 1000000;
  for (int i = 2; i + 1 < argc; i += 2) {
    const std::string key = argv[i], value = argv[i + 1];
    hidden::Settings& s = line.settings;
    if (key == "noise")
      s.noise = std::atof(value.c_str());
    else if (key == "n")
      line.draws = std::atoi(value.c_str());
    else if (key == "seed")
      seed = std::strtoull(value.c_str(), nullptr, 10);
    else if (key == "sensors")
      s.sensors = value;
    else if (key == "corner")
      s.noise_corner_Hz = std::atof(value.c_str());
    else if (key == "bits")
      s.bits = std::atoi(value.c_str());
    else if (key == "kind")
      s.kind = value;
    else if (key == "channel")
      s.channel = value;
    else if (key == "low")
      s.rho_low = std::atof(value.c_str());
    else if (key == "high")
      s.rho_high = std::atof(value.c_str());
    else if (key == "dofs")
      s.dofs = std::atoi(value.c_str());
    else if (key == "seconds")
      s.seconds = std::atof(value.c_str());
    else if (key == "drive")
      s.drive = value == "steps"    ? hidden::Drive::kSteps
                : value == "linear" ? hidden::Drive::kLinear
                                    : hidden::Drive::kSmooth;
    else if (key == "hide")
      s.hide = hide_of(value);
    else
      return std::cerr << "unknown key " << key << "\n", 2;
  }
  const Tally t = run_line(line, seed, &std::cout);
  std::printf("exact %d set %d of %d; CPU mean %.2f s, slowest %.2f s\n", t.exact, t.set, t.draws, t.seconds / t.draws,
              t.slowest);
  for (const auto& limit : t.limits)  // what every "none" printed, % of the damping force
    std::printf("%-32s %.2f\n", limit.first.c_str(), hidden::quantile(limit.second, 0.5));
  return 0;
}

std::string part_of(const std::string& page, size_t line) { return page + ".part" + std::to_string(line); }

int usage(bool asked) {
  (asked ? std::cout : std::cerr)
      << "usage: diagnosis_report [--share S] [--first-seed S] [--jobs N] [--finished-only] FILE.md\n"
         "       diagnosis_report line [noise N] [n DRAWS] [seed S] [sensors xva] [hide none|one|two|outside|fault] "
         "[drive smooth|linear|steps] ...\n";
  return asked ? 0 : 2;
}

// Lines job, job + jobs, ... each into its part.
void work(const std::vector<Line>& lines, const std::string& page, uint64_t seed, size_t job, size_t jobs) {
  for (size_t i = job; i < lines.size(); i += jobs) {
    if (std::filesystem::exists(part_of(page, i))) continue;
    const Tally t = run_line(lines[i], seed, nullptr);
    const std::string whole = part_of(page, i), begun = whole + ".begun";
    {
      std::ofstream out(begun);
      write(out, t);
    }
    std::filesystem::rename(begun, whole);
    std::cout << lines[i].title << ": exact " << t.exact << ", set " << t.set << " of " << t.draws << "\n"
              << std::flush;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "line") return one_line(argc, argv);
  double share = 1;
  size_t jobs = 1;
  uint64_t seed = 7000000;
  std::string page;
  bool finished_only = false;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--share" && i + 1 < argc)
      share = std::atof(argv[++i]);
    else if (key == "--first-seed" && i + 1 < argc)
      seed = std::strtoull(argv[++i], nullptr, 10);
    else if (key == "--jobs" && i + 1 < argc)
      jobs = std::max<size_t>(1, std::strtoull(argv[++i], nullptr, 10));
    else if (key == "--finished-only")
      finished_only = true;
    else if (key[0] == '-' || !page.empty())
      return usage(key == "--help" || key == "-h");
    else
      page = key;
  }
  if (page.empty()) return usage(false);
  const std::vector<Line> all = hidden::report_lines(share);
  std::vector<pid_t> children;
  for (size_t job = 1; job < jobs && !finished_only; ++job) {
    const pid_t child = fork();
    if (child == 0) {
      work(all, page, seed, job, jobs);
      std::exit(0);
    }
    children.push_back(child);
  }
  if (!finished_only) work(all, page, seed, 0, jobs);
  for (pid_t child : children) waitpid(child, nullptr, 0);
  std::vector<Line> lines;
  std::vector<Tally> tallies;
  for (size_t i = 0; i < all.size(); ++i) {
    std::ifstream in(part_of(page, i));
    if (!in && finished_only) continue;
    if (!in) return std::cerr << "diagnosis_report: no result of \"" << all[i].title << "\"\n", 1;
    lines.push_back(all[i]);
    tallies.push_back(hidden::read_tally(in));
    if (!finished_only) std::filesystem::remove(part_of(page, i));
  }
  std::ofstream out(page);
  write_page(out, lines, tallies, seed);
  return out.good() ? 0 : 1;
}
