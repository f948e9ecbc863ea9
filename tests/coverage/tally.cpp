#include "tally.hpp"

#include <cmath>
#include <cstdio>
#include <iterator>

#include "board_answer.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace coverage {
namespace {

using rig_file::to_double;

void judge(const firmware::ParameterEstimate& p, const std::string& name, double truth, uint64_t seed, bool tell,
           Tally& tally) {
  const double value = to_double(p.value), std = to_double(p.std), off = value - truth;
  const bool wrong = std::abs(off) > 0.05 * std::abs(truth) && std::abs(off) > 4 * std;
  ++tally.coefficients;
  ++tally.of_status[static_cast<int>(p.status)];
  if (tell)
    std::printf("  seed %llu %-16s truth %10.5g value %10.5g +- %8.3g plain %10.5g z %7.2f status %d%s\n",
                static_cast<unsigned long long>(seed), name.c_str(), truth, value, std, to_double(p.plain_value),
                off / std, static_cast<int>(p.status), wrong ? " WRONG" : "");
  const bool valid = p.status == firmware::EstimateStatus::kValid;
  if (to_double(p.ci95_high) - to_double(p.ci95_low) < 2 * 0.05 * std::abs(truth)) {
    ++tally.measurable;
    tally.measurable_valid += valid;
  }
  if (!valid) return;
  ++tally.valid;
  if (truth >= to_double(p.ci95_low) && truth <= to_double(p.ci95_high)) ++tally.held;
  if (wrong) ++tally.wrong;
}

}  // namespace

void Tally::add(const Tally& other) {
  coefficients += other.coefficients;
  valid += other.valid;
  held += other.held;
  wrong += other.wrong;
  refused += other.refused;
  measurable += other.measurable;
  measurable_valid += other.measurable_valid;
  for (size_t i = 0; i < std::size(of_status); ++i) of_status[i] += other.of_status[i];
}

Tally count(const std::string& condition, const std::string& sensors, uint64_t first_seed, int draws, bool tell) {
  Tally tally;
  for (int d = 0; d < draws; ++d) {
    hidden_rig::Settings settings;
    settings.condition = condition;
    settings.sensors = sensors;
    const uint64_t seed = first_seed + static_cast<uint64_t>(d);
    const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    try {
      const Answer answer = answer_to(draw.rig, draw.records);
      for (size_t k = 0; k < answer.names.size(); ++k)
        judge(answer.estimates.parameters[k], answer.names[k], draw.coefficients[k].value, seed, tell, tally);
    } catch (const rig_file::RigFileError&) {
      ++tally.refused;
    }
  }
  return tally;
}

}  // namespace coverage
