// The fields of a core's configuration in the order in which they are stored. One list: an archive (archives.hpp) is led along it.
#pragma once
#include "firmware/configuration/configuration.hpp"

namespace firmware {

constexpr int kMostWeights = 3;

template <typename Archive, typename Number>
constexpr void walk_scaled(Archive& archive, Number& number) {
  archive.field(number.mantissa);
  archive.field(number.exponent);
}

template <typename Archive, typename Channel>
constexpr void walk_channel(Archive& archive, Channel& channel) {
  archive.field(channel.present);
  archive.field(channel.offset_code);
  archive.field(channel.lowest_code);
  archive.field(channel.highest_code);
  walk_scaled(archive, channel.unit_per_code);
  archive.field(channel.delay_ns);
}

// Taps beyond the filter's length are zero and are left out.
template <typename Archive, typename Signal>
constexpr void walk_signal(Archive& archive, Signal& signal) {
  archive.field(signal.available);
  archive.field(signal.derived);
  archive.field(signal.source);
  archive.field(signal.integrations);
  archive.field(signal.half_length);
  archive.field(signal.shift);
  archive.field(signal.dropped_bits);
  archive.clear(signal.tap);
  const int half = archive.count(signal.half_length, kFilterHalf);
  for (int i = 0; i <= 2 * half; ++i) archive.field(signal.tap[i].raw);
  walk_scaled(archive, signal.unit_per_code);
}

// What follows `used` is there where it says so; taps beyond the filter's length are zero and are left out.
template <typename Archive, typename Fusion>
constexpr void walk_fusion(Archive& archive, Fusion& fusion, int half_length) {
  archive.field(fusion.used);
  archive.field(fusion.leak_shift);
  archive.clear(fusion.step_tap);
  if (!fusion.used) return;
  const int half = archive.count(half_length, kFusionHalf);
  for (int i = 0; i <= 2 * half; ++i) archive.field(fusion.step_tap[i].raw);
}

// The nodes in use, the base last.
template <typename Core, typename Visit>
constexpr void for_each_node(const Core& core, int dofs, Visit visit) {
  for (int node = 0; node < dofs; ++node) visit(node);
  if (kHasBase && core.base_present) visit(kBaseNode);
}

// Noise that a derived velocity shares with its neighbours; none elsewhere.
template <typename Archive, typename Noise>
constexpr void walk_shared_noise(Archive& archive, Noise& noise, bool derived) {
  for (auto& weight : noise) {
    archive.clear(weight);
    if (!derived) continue;
    for (int q = 1; q < kQuantities; ++q) walk_scaled(archive, weight[q]);
  }
  for (int unused = (kMostWeights - kWeights) * (kQuantities - 1); derived && unused > 0; --unused) {
    Scaled none;
    walk_scaled(archive, none);
  }
}

// Noise that the score tests take out; there where it is shared.
template <typename Archive, typename Core>
constexpr void walk_probe_noise(Archive& archive, Core& core, int node) {
  auto& noise = core.probe_noise[kKeepsProbeNoise ? node : 0];
  for (auto& weight : noise.motion) {
    archive.clear(weight);
    for (auto& covariance : weight)
      if (core.shares_probe_noise) walk_scaled(archive, covariance);
  }
  if (core.shares_probe_noise) walk_scaled(archive, noise.force);
  archive.field(core.motion_noise_doubt[node]);
  archive.field(core.force_noise_doubt[node]);
}

// Of a node: its channels, what the equations use of them, and how a velocity is fused.
template <typename Archive, typename Core>
constexpr void walk_signals(Archive& archive, Core& core, int node) {
  for (auto& channel : core.channels[node]) walk_channel(archive, channel);
  for (auto& signal : core.signals[node]) walk_signal(archive, signal);
  const auto& velocity = core.signals[node][static_cast<int>(Quantity::kVelocity)];
  walk_fusion(archive, core.fusion[node], velocity.half_length);
  walk_shared_noise(archive, core.shared_noise[node], velocity.derived);
  walk_probe_noise(archive, core, node);
}

template <typename Archive, typename Core>
constexpr void walk_sign_filter(Archive& archive, Core& core) {
  archive.field(core.sign_half_length);
  archive.clear(core.sign_tap);
  const int half = archive.count(core.sign_half_length, kSignFilterHalf);
  for (int k = 0; k <= 2 * half; ++k) archive.field(core.sign_tap[k].raw);
}

// Counts first, then what is in use: a core of another capacity reads the same bytes.
template <typename Archive, typename Core>
constexpr void walk_core(Archive& archive, Core& core) {
  archive.field(core.dof_count);
  archive.field(core.link_count);
  archive.field(core.term_count);
  archive.field(core.unknown_count);
  archive.field(core.base_present);
  const int dofs = archive.count(core.dof_count, kMaxDofs), links = archive.count(core.link_count, kMaxLinks);
  const int terms = archive.count(core.term_count, kMaxTerms);
  archive.count(core.unknown_count, kMaxUnknowns);
  archive.count(core.base_present ? 1 : 0, kHasBase ? 1 : 0);
  archive.field(core.shares_probe_noise);
  archive.field(core.noise_unknown);
  walk_scaled(archive, core.sample_period_s);
  for (int l = 0; l < links; ++l) {
    archive.node(core.links[l].node_a);
    archive.node(core.links[l].node_b);
  }
  for (int t = 0; t < terms; ++t) {
    auto& term = core.terms[t];
    archive.field(term.kind);
    archive.field(term.place);
    archive.field(term.unknown);
    walk_scaled(archive, term.value);
    walk_scaled(archive, term.shape);
    archive.field(term.second_shape_q26);
  }
  for_each_node(core, dofs, [&](int node) { walk_signals(archive, core, node); });
  archive.field(core.high_pass_order);
  archive.field(core.high_pass_shift);
  walk_sign_filter(archive, core);
  archive.field(core.window.mode);
  archive.field(core.window.cycle_samples_numerator);
  archive.field(core.window.cycle_samples_denominator);
  archive.field(core.window.batch_samples);
  archive.field(core.probe_products_per_sample);
}

}  // namespace firmware
