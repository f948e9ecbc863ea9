// The frames that a board sends while it estimates: as it starts, every 100 ms, and with each window.
#pragma once
#include <cstdint>
#include <functional>

#include "firmware/can_protocol/can_message.hpp"
#include "firmware/estimator_core.hpp"
#include "hal/configuration/rig_model.hpp"

namespace host_sim {

class EstimateFrames {
 public:
  using Send = std::function<void(const firmware::CanMessage&, uint64_t time_ns)>;
  explicit EstimateFrames(Send send) : send_(std::move(send)) {}

  // Boot-up, identity and the names of the parameters, at time 0. The configuration must outlive this object.
  void begin(const rig_file::RigModel& model, const firmware::CoreConfiguration& configuration);
  void heartbeat(uint64_t time_ns);
  // Names of the parameters, status, window, one frame per estimate, health.
  void window(uint64_t time_ns, const firmware::Estimates& estimates, const firmware::CoreHealth& health, bool last);

 private:
  void send_names(uint64_t time_ns);

  Send send_;
  const firmware::CoreConfiguration* configuration_ = nullptr;
  bool rotating_ = false;
};

}  // namespace host_sim
