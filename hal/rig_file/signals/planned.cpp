#include "hal/rig_file/signals/planned.hpp"

#include <algorithm>

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

template <typename Test>
bool any(const CoreConfiguration& c, Test test) {
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (c.signals[node][q].available && test(node, q)) return true;
  return false;
}

bool delayed(const CoreConfiguration& c) {
  return any(c, [&](int node, int q) { return c.channels[node][c.signals[node][q].source].delay_ns != 0; });
}
bool fuses(const CoreConfiguration& c) {
  return any(c, [&](int node, int) { return c.fusion[node].used; });
}

}  // namespace

std::string node_name(int node) { return node == firmware::kBaseNode ? "the base" : "DOF " + std::to_string(node + 1); }

bool fused(const CoreConfiguration& c, int node, int q) { return q == kV && c.fusion[node].used; }

int derivatives(const CoreConfiguration& c, int node, int q) {
  const SignalConfiguration& signal = c.signals[node][q];
  return signal.derived && signal.source < q && !fused(c, node, q) ? q - signal.source : 0;
}

int most_integrations(const CoreConfiguration& c) {
  int most = 0;
  for (const auto& node : c.signals)
    for (const SignalConfiguration& signal : node) most = std::max<int>(most, signal.integrations);
  return most;
}

bool differentiates(const CoreConfiguration& c) {
  return any(c, [&](int node, int q) { return derivatives(c, node, q) > 0; });
}

bool integrates(const CoreConfiguration& c) { return most_integrations(c) > 0; }

bool differentiates_twice(const CoreConfiguration& c) {
  return any(c, [&](int node, int q) { return derivatives(c, node, q) > 1; });
}

// A delayed channel's filter has no room for more.
Band band(const CoreConfiguration& c, const SignalRanges& ranges) {
  return ranges.wide_band && differentiates(c) && !delayed(c) ? Band::kWide : Band::kTenth;
}

bool filtered(const CoreConfiguration& c) {
  return differentiates(c) || delayed(c) || fuses(c) || c.high_pass_order > 0;
}

bool coloured_displacement(const CoreConfiguration& c, const SignalRanges& ranges) {
  for (int node = 0; node < c.dof_count; ++node)
    if (c.channels[node][kX].present && !ranges.noise[node][kX].white()) return true;
  return false;
}

bool has_friction(const CoreConfiguration& c) {
  return std::any_of(c.terms, c.terms + c.term_count,
                     [](const firmware::Term& term) { return firmware::is_sign_term(term.kind); });
}

}  // namespace rig_file
