// The controller's configuration for a host that replays samples: node 1, a window every second.
#pragma once
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

firmware::ControllerConfiguration board_configuration(const rig_file::RigModel& model,
                                                      const firmware::CoreConfiguration& core, double sample_period_s);

}  // namespace host_sim
