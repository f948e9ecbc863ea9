// The fields of a controller's configuration behind those of its core, in the order in which they are stored.
#pragma once
#include "core_fields.hpp"

namespace firmware {

template <typename Archive, typename Level>
constexpr void walk_level(Archive& archive, Level& level) {
  archive.field(level.kind);
  archive.field(level.amplitude.raw);
  archive.field(level.phase_step);
  archive.field(level.high_phase_step);
  archive.field(level.seed);
  archive.field(level.ramp_samples);
  archive.field(level.settle.block_samples);
  archive.field(level.settle.bound_per_mille);
  archive.field(level.settle.blocks);
  archive.field(level.settle.floor_code);
  archive.field(level.settle_limit_samples);
  archive.field(level.skip_when_unsettled);
  archive.field(level.measure_samples);
}

template <typename Archive, typename Programme>
constexpr void walk_programme(Archive& archive, Programme& programme) {
  archive.field(programme.level_count);
  archive.field(programme.start_at_boot);
  archive.field(programme.limits.magnitude.raw);
  archive.field(programme.limits.step_per_sample.raw);
  const int levels = archive.count(programme.level_count, kMaxLevels);
  for (int l = 0; l < levels; ++l) walk_level(archive, programme.levels[l]);
}

template <typename Archive, typename Limits, typename Core>
constexpr void walk_limits(Archive& archive, Limits& limits, const Core& core) {
  archive.field(limits.saturated_in_row);
  archive.field(limits.lost_in_row);
  archive.field(limits.sample_timeout_us);
  archive.field(limits.step_timeout_us);
  for_each_node(core, archive.count(core.dof_count, kMaxDofs), [&](int node) {
    for (auto& code : limits.response_limit_code[node]) archive.field(code);
  });
}

template <typename Archive, typename Node>
constexpr void walk_node(Archive& archive, Node& node) {
  archive.field(node.node);
  archive.field(node.can_fd);
  archive.field(node.float_estimates);
  archive.field(node.sync_closes_window);
  archive.field(node.listen_on_command);
  archive.field(node.drive_on_can);
  archive.field(node.heartbeat_ms);
  archive.field(node.status_ms);
  archive.field(node.emergency_inhibit_ms);
  archive.field(node.window_samples);
  archive.field(node.rotating_nodes);
}

template <typename Archive, typename Configuration>
constexpr void walk_rig(Archive& archive, Configuration& configuration) {
  walk_core(archive, configuration.core);
  walk_programme(archive, configuration.programme);
  walk_limits(archive, configuration.limits, configuration.core);
}

}  // namespace firmware
