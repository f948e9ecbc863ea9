#include "host_sim/virtual_rig/board_configuration.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kWindow_s = 1.0;

}  // namespace

firmware::ControllerConfiguration board_configuration(const rig_file::RigModel& model,
                                                      const firmware::CoreConfiguration& core, double sample_period_s) {
  firmware::ControllerConfiguration configuration;
  configuration.core = core;
  configuration.node.window_samples = static_cast<uint32_t>(std::max(1.0, std::nearbyint(kWindow_s / sample_period_s)));
  for (size_t i = 0; i < model.dofs.size() && i < 32; ++i)
    if (model.dofs[i].rotating) configuration.node.rotating_nodes |= 1u << i;
  return configuration;
}

}  // namespace host_sim
