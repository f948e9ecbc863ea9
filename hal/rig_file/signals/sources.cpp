#include "hal/rig_file/signals/sources.hpp"

#include "firmware/links/effect_laws.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/signals/high_pass.hpp"
#include "hal/rig_file/signals/leak.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

bool displacement_needed(const CoreConfiguration& c, int node) {
  for (int t = 0; t < c.term_count; ++t) {
    const firmware::Term& term = c.terms[t];
    if (!firmware::reads_elongation(term.kind)) continue;
    const firmware::LinkConfiguration& link = c.links[term.place];
    if (link.node_a == node || link.node_b == node) return true;
  }
  return false;
}

bool mass_needed(const CoreConfiguration& c, int node) {
  for (int t = 0; t < c.term_count; ++t)
    if (c.terms[t].kind == firmware::TermKind::kMass && c.terms[t].place == node) return true;
  return false;
}

void take(CoreConfiguration& c, int node, int q, int source) {
  SignalConfiguration& signal = c.signals[node][q];
  signal.available = true;
  signal.source = static_cast<uint8_t>(source);
  signal.derived = source != q;
  signal.integrations = static_cast<uint8_t>(source > q ? source - q : 0);
  signal.unit_per_code = c.channels[node][source].unit_per_code;
}

void choose_node(CoreConfiguration& c, const SignalRanges& ranges, bool fuse, int node, bool is_base) {
  const auto measured = [&](int q) { return c.channels[node][q].present; };
  if (measured(kF)) take(c, node, kF, kF);
  if (!measured(kX) && !measured(kV) && !measured(kA))
    throw RigFileError("rig", 0, "channels of " + node_name(node),
                       "no motion is measured, expected a displacement, velocity or acceleration channel");
  c.fusion[node].used = fuse && !measured(kV) && measured(kX) && measured(kA);
  c.fusion[node].leak_shift = static_cast<uint8_t>(leak_shift(c, ranges, node));
  take(c, node, kV, measured(kV) ? kV : (measured(kX) ? kX : kA));
  if (measured(kX)) {
    take(c, node, kX, kX);
  } else if (displacement_needed(c, node)) {
    take(c, node, kX, measured(kV) ? kV : kA);
  }
  if (measured(kA)) {
    take(c, node, kA, kA);
  } else if (!is_base && mass_needed(c, node) && !(measured(kV) && measured(kX))) {
    take(c, node, kA, measured(kV) ? kV : kX);
  }
}

void choose_sources(CoreConfiguration& c, const SignalRanges& ranges, bool fuse) {
  for (int node = 0; node < firmware::kMaxNodes; ++node) {
    for (int q = 0; q < kQuantities; ++q) c.signals[node][q] = SignalConfiguration{};
    c.fusion[node] = firmware::FusionConfiguration{};
    const bool is_base = node == firmware::kBaseNode;
    if (node >= c.dof_count && !(is_base && c.base_present)) continue;
    choose_node(c, ranges, fuse, node, is_base);
  }
  choose_high_pass(c, ranges);
}

}  // namespace

void choose_sources(CoreConfiguration& c, const SignalRanges& ranges) {
  choose_sources(c, ranges, true);
  if (differentiates(c) || c.high_pass_order > 0) choose_sources(c, ranges, false);
}

}  // namespace rig_file
