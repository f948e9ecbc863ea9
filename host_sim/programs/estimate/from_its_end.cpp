#include "host_sim/programs/estimate/from_its_end.hpp"

#include <algorithm>

#include "firmware/identification/rows/backward_time.hpp"
#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

bool remembers(const rig_file::Effect& effect) {
  const firmware::EffectRow* const row = firmware::find_effect(effect.kind.c_str());
  return row == nullptr || row->nature.memory != firmware::Memory::kNone;
}

template <typename Place>
bool any_remembers(const std::vector<Place>& places) {
  return std::any_of(places.begin(), places.end(), [](const Place& place) {
    return std::any_of(place.effects.begin(), place.effects.end(), remembers);
  });
}

}  // namespace

bool begins_in_motion(const rig_file::RigModel& model, const std::vector<Record>& records) {
  const Record& record = records.front();
  if (any_has_drive(records)) return false;
  if (any_remembers(model.dofs) || any_remembers(model.links)) return false;
  for (const Channel& channel : record.channels)
    if (record.find(Quantity::kDisplacement, channel.dof) == nullptr) return true;
  return false;
}

std::vector<Record> backwards(const std::vector<Record>& records) {
  std::vector<Record> turned = records;
  for (Record& record : turned)
    for (Channel& channel : record.channels) {
      std::reverse(channel.values.begin(), channel.values.end());
      if (channel.quantity != Quantity::kVelocity) continue;
      for (double& value : channel.values) value = -value;
    }
  return turned;
}

rig_file::RigModel backwards(rig_file::RigModel model) {
  for (rig_file::ChannelEntry& channel : model.channels) channel.delay_us = -channel.delay_us;
  return model;
}

void run_back(firmware::CoreConfiguration& configuration) {
  configuration.time_runs_back = true;
  for (int t = 0; t < configuration.term_count; ++t) {
    firmware::Term& term = configuration.terms[t];
    if (term.unknown < 0) term.value = firmware::forwards(configuration, term.kind, term.value);
  }
}

}  // namespace host_sim
