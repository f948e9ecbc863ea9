// The frames that a board would send while it is fed the same samples, collected as a candump log.
#pragma once
#include <sstream>
#include <string>

#include "firmware/estimator_core.hpp"
#include "hal/configuration/rig_model.hpp"
#include "host_sim/can_log/log_writer.hpp"

namespace host_sim {

class EstimateFrames {
 public:
  // Begins with boot-up, identity and the names of the parameters. Times count from the first sample of the first
  // record.
  EstimateFrames(const rig_file::RigModel& model, const firmware::CoreConfiguration& configuration);

  void heartbeat(uint64_t time_ns);
  // Status, window, one frame per estimate, health.
  void window(uint64_t time_ns, const firmware::Estimates& estimates, const firmware::CoreHealth& health, bool last);

  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  can_log::LogWriter log_;
};

}  // namespace host_sim
