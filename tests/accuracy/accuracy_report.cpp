// Measures every case of the accuracy report and writes the page.  accuracy_report [--draws N] [--only NAME] [FILE]
// FILE: where the page goes, whole or not at all (default: standard output). Exit status 2: bad usage.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>

#include "hal/rig_file/compile_rig.hpp"
#include "tests/accuracy/report.hpp"

namespace {

struct Options {
  int draws = 1000;
  std::string only, file;
};

bool parse(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; ++i) {
    const bool more = i + 1 < count;
    if (std::strcmp(arguments[i], "--draws") == 0 && more) {
      options.draws = std::atoi(arguments[++i]);
    } else if (std::strcmp(arguments[i], "--only") == 0 && more) {
      options.only = arguments[++i];
    } else if (arguments[i][0] != '-' && options.file.empty()) {
      options.file = arguments[i];
    } else {
      return false;
    }
  }
  return options.draws >= 2;
}

bool wanted(const Options& options, const std::string& name) {
  return options.only.empty() || name.find(options.only) != std::string::npos;
}

// A second of measurement is so quick to draw that its figures can be sharper.
int draws_of(const host_sim::Scenario& scenario, const Options& options) {
  size_t samples = 0;
  for (const host_sim::ExcitationLevel& level : scenario.levels) samples += level.samples;
  return samples <= 1000 ? 10 * options.draws : options.draws;
}

// Shares of intervals that hold, pooled over parameters by kind of excitation.
class Coverage {
 public:
  void add(host_sim::LevelKind kind, const accuracy::CaseStatistics& statistics) {
    for (const accuracy::ParameterStatistics& p : statistics.parameters) {
      sum_[kind] += p.coverage_percent;
      count_[kind] += 1.0;
    }
  }
  std::vector<std::pair<std::string, double>> percent() const {
    std::vector<std::pair<std::string, double>> result;
    for (const auto& [kind, sum] : sum_)
      result.emplace_back(kind == host_sim::LevelKind::kRandom      ? "random"
                          : kind == host_sim::LevelKind::kFreeDecay ? "free decay"
                                                                    : "periodic",
                          sum / count_.at(kind));
    return result;
  }

 private:
  std::map<host_sim::LevelKind, double> sum_, count_;
};

std::string measure_all(const Options& options) {
  std::string page = accuracy::page_head(options.draws);
  std::vector<std::pair<accuracy::Case, accuracy::CaseStatistics>> measured;
  std::vector<accuracy::CleanRow> clean;
  for (const accuracy::CleanCase& c : accuracy::clean_cases())
    if (wanted(options, c.name))
      clean.push_back({c.name, accuracy::clean_error_percent(c.scenario), c.limit_percent, c.paper_percent});
  page += accuracy::clean_section(clean);
  Coverage coverage;
  for (const accuracy::Case& c : accuracy::noisy_cases()) {
    if (!wanted(options, c.name)) continue;
    std::fprintf(stderr, "accuracy_report: %s\n", c.name.c_str());
    const accuracy::CaseStatistics statistics = accuracy::measure_case(c.scenario, 1000, draws_of(c.scenario, options));
    page += accuracy::case_section(c, statistics);
    coverage.add(c.scenario.levels.front().kind, statistics);
    measured.emplace_back(c, statistics);
  }
  page = accuracy::page_opening() + accuracy::summary_section(measured) + page;
  page += accuracy::coverage_section(coverage.percent());
  if (!options.only.empty()) return page;
  const std::vector<std::string> names = rig_file::parameter_names(accuracy::clean_cases()[3].scenario.rig);
  std::fprintf(stderr, "accuracy_report: skew, sensor sets, advice\n");
  page += accuracy::skew_section(accuracy::measure_skew(options.draws), names);
  page += accuracy::sensor_section(accuracy::measure_sensor_sets(options.draws / 4 + 1), options.draws / 4 + 1);
  page += accuracy::advice_section(accuracy::follow_advice(options.draws / 4 + 1));
  return page;
}

bool write_whole(const std::string& file, const std::string& page) {
  const std::string temporary = file + ".part";
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream << page;
    if (!stream.flush()) return false;
  }
  return std::rename(temporary.c_str(), file.c_str()) == 0;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  if (!parse(count, arguments, options)) {
    std::cerr << "usage: accuracy_report [--draws N, 2 or more] [--only NAME] [FILE]\n";
    return 2;
  }
  const std::string page = measure_all(options);
  if (options.file.empty()) {
    std::cout << page;
    return 0;
  }
  if (write_whole(options.file, page)) return 0;
  std::cerr << "accuracy_report: " << options.file << " cannot be written, expected a writable folder\n";
  return 1;
}
