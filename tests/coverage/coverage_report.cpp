// Nothing hidden: how often 95 % intervals hold, by condition and sensor set.
//   coverage_report [--draws N] [--first SEED] [--condition NAME ...] [--sensors SET ...] [--tell]
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "board_answer.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace {

using firmware::EstimateStatus;

struct Tally {
  int coefficients = 0, valid = 0, held = 0, wrong = 0, precise = 0;
  int status[16] = {};
  double sum_z = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("coverage");
  int draws = 8;
  uint64_t first = 1000;
  std::vector<std::string> names, sets = {"xva", "xa", "x", "a", "v"};
  bool tell = false;
  std::string hidden = "none";
  app.add_option("--draws", draws, "");
  app.add_option("--first", first, "");
  app.add_option("--condition", names, "");
  app.add_option("--sensors", sets, "");
  app.add_option("--hidden", hidden, "");
  app.add_flag("--tell", tell, "");
  CLI11_PARSE(app, argc, argv);
  if (names.empty())
    for (const hidden_rig::Condition& c : hidden_rig::conditions()) names.push_back(c.name);
  std::printf("%-24s %-4s %5s %6s %6s %6s  %s\n", "condition", "set", "coef", "valid%", "hold%", "wrong", "status: V ST B SK IL NO SA ..; z mean of VALID");
  std::vector<Tally> total(sets.size());
  for (const std::string& name : names)
    for (size_t s = 0; s < sets.size(); ++s) {
      Tally t;
      for (int d = 0; d < draws; ++d) {
        hidden_rig::Settings settings;
        settings.condition = name, settings.sensors = sets[s], settings.hidden = hidden;
        try {
          const hidden_rig::Draw draw = hidden_rig::make_draw(first + static_cast<uint64_t>(d), settings);
          const coverage::Answer answer = coverage::answer_to(draw.rig, draw.records);
          for (size_t k = 0; k < answer.names.size(); ++k) {
            const firmware::ParameterEstimate& p = answer.estimates.parameters[k];
            const double truth = draw.coefficients[k].value, value = rig_file::to_double(p.value),
                         std = rig_file::to_double(p.std);
            const double z = (value - truth) / std;
            const bool holds = truth >= rig_file::to_double(p.ci95_low) && truth <= rig_file::to_double(p.ci95_high);
            const bool wrong = std::abs(value - truth) > 0.05 * truth && std::abs(z) > 4;
            ++t.coefficients, ++t.status[static_cast<int>(p.status)];
            if (p.status == EstimateStatus::kValid) ++t.valid, t.held += holds, t.wrong += wrong, t.sum_z += z;
            if (tell)
              std::printf("  seed %llu %-16s truth %10.5g value %10.5g +- %8.3g plain %10.5g z %7.2f inflation %6.2f status %d%s\n",
                          static_cast<unsigned long long>(first) + static_cast<unsigned long long>(d), answer.names[k].c_str(), truth, value, std,
                          rig_file::to_double(p.plain_value), z, rig_file::to_double(p.variance_inflation),
                          static_cast<int>(p.status), wrong ? " WRONG" : "");
          }
        } catch (const std::exception& e) {
          std::printf("  %s seed %llu: %s\n", name.c_str(), static_cast<unsigned long long>(first) + static_cast<unsigned long long>(d), e.what());
        }
      }
      std::printf("%-24s %-4s %5d %6.1f %6.1f %6d  ", name.c_str(), sets[s].c_str(), t.coefficients,
                  100.0 * t.valid / std::max(1, t.coefficients), 100.0 * t.held / std::max(1, t.valid), t.wrong);
      for (int i = 0; i < 9; ++i) std::printf(" %d", t.status[i]);
      std::printf("  %.2f\n", t.sum_z / std::max(1, t.valid));
      std::fflush(stdout);
      total[s].coefficients += t.coefficients, total[s].valid += t.valid, total[s].held += t.held, total[s].wrong += t.wrong;
    }
  for (size_t s = 0; s < sets.size(); ++s)
    std::printf("%-24s %-4s %5d %6.1f %6.1f %6d\n", "all", sets[s].c_str(), total[s].coefficients,
                100.0 * total[s].valid / std::max(1, total[s].coefficients), 100.0 * total[s].held / std::max(1, total[s].valid), total[s].wrong);
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
