#include "host_sim/data_check/channel/channel_report.hpp"

#include <algorithm>
#include <utility>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/data_check/channel/ripple.hpp"
#include "host_sim/data_check/channel/slow_faults.hpp"
#include "host_sim/data_check/channel/staircase.hpp"
#include "host_sim/data_check/flat/clipping.hpp"
#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/data_check/spikes/spikes.hpp"

namespace host_sim::data_check {
namespace {

// How often the estimation differentiates a channel: as often as no other channel of the DOF spares it.
int differentiated(const Record& record, const Channel& channel) {
  const bool velocity = record.find(Quantity::kVelocity, channel.dof) != nullptr,
             acceleration = record.find(Quantity::kAcceleration, channel.dof) != nullptr;
  if (channel.quantity == Quantity::kDisplacement) return velocity || acceleration ? (velocity ? 0 : 1) : 2;
  if (channel.quantity == Quantity::kVelocity) return acceleration ? 0 : 1;
  return 0;
}

// What the velocity of a DOF spans, from its velocity or displacement; 0 where neither is there.
double velocity_range(const Record& record, const std::vector<Statistics>& statistics, int dof) {
  if (const Channel* velocity = record.find(Quantity::kVelocity, dof))
    return statistics[static_cast<size_t>(velocity - record.channels.data())].range;
  const Channel* displacement = record.find(Quantity::kDisplacement, dof);
  if (displacement == nullptr || displacement->values.size() < 8) return 0.0;
  std::vector<double> velocity(displacement->values.size() - 4);
  for (size_t i = 0; i < velocity.size(); ++i)
    velocity[i] = (displacement->values[i + 4] - displacement->values[i]) / (4.0 * record.sample_period_s);
  return quantile(velocity, 0.999) - quantile(velocity, 0.001);
}

double velocity_step(const Record& record, const Channel& channel, const rig_file::RigModel* model) {
  if (channel.quantity == Quantity::kAcceleration) return record.sample_period_s;
  if (channel.quantity != Quantity::kForce || model == nullptr || channel.dof < 1) return 0.0;
  const rig_file::Coefficient& mass = model->dofs[static_cast<size_t>(channel.dof - 1)].mass_kg;
  return mass.estimate || !(mass.value > 0.0) ? 0.0 : record.sample_period_s / mass.value;
}

// The converter's ends in SI, where the rig file knows them.
std::pair<double, double> converter_limits(const Channel& channel, const rig_file::RigModel* model) {
  const rig_file::ChannelEntry* const entry = model == nullptr ? nullptr : rig_file::entry_of(*model, channel.name);
  if (entry == nullptr || entry->unit_per_code == 0.0 || entry->highest_code <= entry->lowest_code) return {0.0, 0.0};
  const double a = (entry->lowest_code - entry->offset_code) * entry->unit_per_code,
               b = (entry->highest_code - entry->offset_code) * entry->unit_per_code;
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

ChannelReport report_of(const Record& record, const std::vector<Statistics>& all, size_t index,
                        const rig_file::RigModel* model) {
  const Channel& channel = record.channels[index];
  const Statistics& statistics = all[index];
  ChannelReport report{channel.name, statistics.rms, statistics.mean, statistics.noise, statistics.resolution, {}};
  if (statistics.lowest == statistics.highest) return report;
  Neighbours neighbours{record, differentiated(record, channel), 0.0, 0.0, {}};
  for (size_t i = 0; i < all.size(); ++i)
    if (record.channels[i].quantity == Quantity::kForce) neighbours.forces.push_back({&record.channels[i], &all[i]});
  if (channel.dof >= 1) {
    neighbours.velocity_step = velocity_step(record, channel, model);
    if (neighbours.velocity_step > 0.0) neighbours.velocity_range = velocity_range(record, all, channel.dof);
  }
  if (auto spikes = find_spikes(channel, statistics, neighbours)) {
    report.findings.push_back(std::move(*spikes));
  } else {
    const auto [low, high] = converter_limits(channel, model);
    if (auto clipped = find_clipping(channel, statistics, low, high, &record))
      report.findings.push_back(std::move(*clipped));
  }
  if (auto staircase = find_staircase(record, channel, statistics)) report.findings.push_back(std::move(*staircase));
  for (Finding& finding : find_slow_faults(record, channel, statistics, differentiated(record, channel)))
    report.findings.push_back(std::move(finding));
  if (model != nullptr)
    if (auto ripple = find_ripple(record, channel, *model)) report.findings.push_back(std::move(*ripple));
  return report;
}

}  // namespace host_sim::data_check
