#include "host_sim/programs/estimate_frames.hpp"

#include <algorithm>

#include "firmware/can_protocol/estimate_frames.hpp"
#include "firmware/can_protocol/packing.hpp"

namespace host_sim {
namespace {

constexpr int kNode = 1;

}  // namespace

void EstimateFrames::begin(const rig_file::RigModel& model, const firmware::CoreConfiguration& configuration) {
  configuration_ = &configuration;
  rotating_ = std::any_of(model.dofs.begin(), model.dofs.end(), [](const rig_file::Dof& dof) { return dof.rotating; });
  send_(firmware::pack_heartbeat(kNode, firmware::HeartbeatState::kBootUp), 0);
  firmware::Identity identity;
  identity.version_minor = 1;
  identity.parameters = configuration.unknown_count;
  send_(firmware::pack_identity(kNode, identity), 0);
  send_names(0);
}

void EstimateFrames::send_names(uint64_t time_ns) {
  for (int i = 0; i < configuration_->unknown_count; ++i) {
    firmware::ParameterDescription parameter;
    if (firmware::describe_parameter(*configuration_, i, rotating_, parameter))
      send_(firmware::pack_parameter(kNode, parameter), time_ns);
  }
}

void EstimateFrames::heartbeat(uint64_t time_ns) {
  send_(firmware::pack_heartbeat(kNode, firmware::HeartbeatState::kOperational), time_ns);
}

void EstimateFrames::window(uint64_t time_ns, const firmware::Estimates& estimates,
                            const firmware::CoreHealth& core_health, bool last) {
  send_names(time_ns);
  const auto mode = last ? firmware::ControllerMode::kDone : firmware::ControllerMode::kIntegrate;
  uint16_t faults = 0;
  if (core_health.saturated_samples > 0) faults |= firmware::fault_bit(firmware::Fault::kSensorSaturated);
  if (core_health.missed_samples > 0) faults |= firmware::fault_bit(firmware::Fault::kSamplesMissed);
  send_(firmware::pack_status(kNode, firmware::node_status(estimates, mode, faults)), time_ns);
  send_(firmware::pack_window(kNode, firmware::window_result(estimates)), time_ns);
  for (int i = 0; i < estimates.unknown_count; ++i)
    send_(firmware::pack_estimate(kNode, i, estimates.parameters[i], estimates.window_counter), time_ns);
  firmware::NodeHealth health;
  health.uptime_s = static_cast<uint32_t>(time_ns / 1000000000u);
  health.core = core_health;
  send_(firmware::pack_health(kNode, health), time_ns);
}

}  // namespace host_sim
