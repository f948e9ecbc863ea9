#include "host_sim/data_check/one_motion/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/data_check/measures/unit_factors.hpp"
#include "host_sim/data_check/one_motion/comparison.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kGainCorrelation = 0.95;  // then noise bends the gain by less than 5 %
constexpr double kPlainGain = 3.0;         // no calibration is off by more
constexpr double kUnitTolerance = 0.05;

// What is said of one DOF: its pairs of channels, and the findings so far.
struct Motion {
  const Record& record;
  int dof;
  bool rotating;
  std::vector<Comparison> pairs;
  std::vector<Finding> findings;

  const std::string& name(Quantity quantity) const { return record.find(quantity, dof)->name; }
  Dimension dimension(Quantity quantity) const {
    return dimension_of(static_cast<firmware::Quantity>(quantity), rotating);
  }
  // With three channels the one that two pairs complain about; else the one that differentiates more.
  template <typename IsBad>
  std::ptrdiff_t count_bad(Quantity quantity, IsBad is_bad) const {
    return std::count_if(pairs.begin(), pairs.end(), [&](const Comparison& pair) {
      return (pair.lower == quantity || pair.upper == quantity) && is_bad(pair);
    });
  }
  void add(Finding finding) {
    for (const Finding& earlier : findings)
      if (earlier.kind == finding.kind && earlier.channel == finding.channel) return;
    findings.push_back(std::move(finding));
  }
};

std::vector<Comparison> pairs_of(const Record& record, int dof, Integrals& integrals) {
  constexpr Quantity kMotion[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};
  std::vector<Comparison> pairs;
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j) {
      const Channel *lower = record.find(kMotion[i], dof), *upper = record.find(kMotion[j], dof);
      if (lower == nullptr || upper == nullptr) continue;
      if (const auto pair = compare(*lower, *upper, record.sample_period_s, integrals)) pairs.push_back(*pair);
    }
  return pairs;
}

bool is_turned(const Comparison& pair) { return pair.turned; }

bool is_off(const Comparison& pair) {
  return std::abs(pair.correlation) > kGainCorrelation &&
         (std::abs(pair.gain) > kPlainGain || std::abs(pair.gain) < 1.0 / kPlainGain);
}

void add_polarity(const Comparison& pair, Motion& motion) {
  const bool lower = motion.count_bad(pair.lower, is_turned) > motion.count_bad(pair.upper, is_turned);
  const std::string blamed = motion.name(lower ? pair.lower : pair.upper),
                    other = motion.name(lower ? pair.upper : pair.lower);
  Finding finding{"polarity", Weight::kFault, blamed, "", pair.correlation};
  finding.detail = "points against " + other +
                   fmt::format(" (correlation of the same motion {:.2f})", pair.correlation) +
                   ": the sensor is turned over or its leads are exchanged; change the sign of the column";
  if (motion.pairs.size() == 1) finding.detail += " (or that of " + other + ")";
  motion.add(std::move(finding));
}

// Whether the upper channel's numbers are the ones that a unit makes too large, or the lower one's; nothing where no unit does.
std::optional<bool> unit_blames_upper(const Comparison& pair, const Motion& motion) {
  const double factor = std::abs(pair.gain);
  if (unit_reading(motion.dimension(pair.upper), factor, kUnitTolerance)) return true;
  if (unit_reading(motion.dimension(pair.lower), 1.0 / factor, kUnitTolerance)) return false;
  return std::nullopt;
}

void add_unit(const Comparison& pair, Motion& motion) {
  const auto of_upper = motion.count_bad(pair.upper, is_off), of_lower = motion.count_bad(pair.lower, is_off);
  const bool upper = of_upper == of_lower ? unit_blames_upper(pair, motion).value_or(true) : of_upper > of_lower;
  const double factor = upper ? std::abs(pair.gain) : 1.0 / std::abs(pair.gain);
  const Quantity blamed = upper ? pair.upper : pair.lower, other = upper ? pair.lower : pair.upper;
  Finding finding{"unit", Weight::kFault, motion.name(blamed), "", factor};
  finding.detail = "is " + fmt::format("{:.4g} times what ", factor) + motion.name(other) + " says of the same motion";
  const auto unit = unit_reading(motion.dimension(blamed), factor, kUnitTolerance);
  finding.detail += unit ? ": its numbers are in " + *unit + "; name the unit in the column's head or with --unit"
                         : ": its unit or its calibration is wrong";
  motion.add(std::move(finding));
}

void add_skew(const Comparison& pair, const rig_file::RigModel* model, Motion& motion) {
  const auto stated_s = [&](Quantity quantity) {
    return model == nullptr ? 0.0 : rig_file::stated_delay_s(*model, motion.name(quantity));
  };
  const double late_s = pair.late_s - (stated_s(pair.upper) - stated_s(pair.lower));
  const double samples = late_s / motion.record.sample_period_s;
  if (pair.turned || !(pair.correlation > kGainCorrelation) || !(std::abs(samples) > 0.1) ||
      !(std::abs(samples) < 10.0) || !(std::abs(late_s) > 5.0 * pair.late_std_s))
    return;
  Finding finding{"skew", Weight::kInforms, motion.name(pair.upper), "", late_s};
  finding.detail =
      fmt::format(late_s > 0.0 ? "is {:.3g} us late against " : "is {:.3g} us ahead of ", std::abs(late_s) * 1e6) +
      motion.name(pair.lower) + fmt::format(" (+- {:.2g})", 2e6 * pair.late_std_s);
  motion.add(std::move(finding));
}

}  // namespace

std::vector<Finding> check_kinematics(const Record& record, int dof, bool rotating, const rig_file::RigModel* model,
                                      Integrals& integrals) {
  Motion motion{record, dof, rotating, pairs_of(record, dof, integrals), {}};
  for (const Comparison& pair : motion.pairs) {
    if (is_turned(pair)) add_polarity(pair, motion);
    if (is_off(pair)) add_unit(pair, motion);
    add_skew(pair, model, motion);
  }
  return std::move(motion.findings);
}

}  // namespace host_sim::data_check
