#include "host_sim/programs/estimate/delay_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim {
namespace {

constexpr double kWellMeasured = 8.0;  // standard deviations
constexpr double kMostPeriods = 3.0;

// The delays of one DOF's displacement and acceleration against its velocity.
struct OfDof {
  const SkewResult* displacement = nullptr;
  const SkewResult* acceleration = nullptr;
};

std::optional<DelayCorrection> choose(const OfDof& dof) {
  const SkewResult* x = dof.displacement;
  const SkewResult* a = dof.acceleration;
  if (x != nullptr && a != nullptr) {
    const double difference = std::fabs(x->late_us - a->late_us), noise = std::hypot(x->std_us, a->std_us);
    if (difference > 4.0 * noise && difference > 0.1 * std::fabs(x->late_us)) return std::nullopt;  // all three differ
    rig_file::ChannelName name = *rig_file::parse_channel_name(x->channel);
    name.quantity = firmware::Quantity::kVelocity;
    return DelayCorrection{rig_file::format_channel_name(name), -x->late_us, x->std_us};
  }
  const SkewResult* one = x != nullptr ? x : a;
  return DelayCorrection{one->channel, one->late_us, one->std_us};
}

}  // namespace

std::vector<DelayCorrection> delays_to_correct(const std::vector<SkewResult>& skews, double sample_period_s) {
  std::map<int, OfDof> dofs;
  for (const SkewResult& skew : skews) {
    const auto name = rig_file::parse_channel_name(skew.channel);
    if (!skew.significant || !name) continue;
    OfDof& dof = dofs[name->dof];
    (name->quantity == firmware::Quantity::kDisplacement ? dof.displacement : dof.acceleration) = &skew;
  }
  std::vector<DelayCorrection> corrections;
  for (const auto& [number, dof] : dofs) {
    const std::optional<DelayCorrection> correction = choose(dof);
    if (!correction || std::fabs(correction->late_us) < kWellMeasured * correction->std_us) continue;
    if (std::fabs(correction->late_us) * 1e-6 > kMostPeriods * sample_period_s) continue;
    corrections.push_back(*correction);
  }
  return corrections;
}

rig_file::RigModel with_delays(const rig_file::RigModel& model, const std::vector<DelayCorrection>& corrections) {
  rig_file::RigModel result = model;
  for (const DelayCorrection& correction : corrections) {
    auto entry = std::find_if(result.channels.begin(), result.channels.end(),
                              [&](const auto& channel) { return channel.name == correction.channel; });
    if (entry == result.channels.end()) {
      result.channels.emplace_back();
      entry = result.channels.end() - 1;
      entry->name = correction.channel;
    }
    entry->delay_us += correction.late_us;
  }
  return result;
}

std::string correction_note(const DelayCorrection& c) {
  return fmt::format("{} was {:.0f} us {} against the other channels of its DOF (+- {:.1f}): corrected", c.channel,
                     std::fabs(c.late_us), c.late_us > 0 ? "late" : "early", 2.0 * c.std_us);
}

}  // namespace host_sim
