// One simulated scenario, many noise draws: the plant is integrated once, only the sensors' noise is drawn anew.
#pragma once
#include <memory>
#include <vector>

#include "firmware/estimator_core.hpp"
#include "host_sim/plant/instruments/sensors.hpp"
#include "host_sim/plant/scenario/scenario.hpp"

namespace accuracy {

class Redraw {
 public:
  explicit Redraw(const host_sim::Scenario& scenario);

  // Feeds the core with the records under the noise of this seed; noisy = false: without any.
  // The records stay until the next call.
  const firmware::Estimates& run(uint64_t seed, bool noisy = true);
  const std::vector<host_sim::Record>& records() const { return noisy_; }
  // The samples of the last run, a list per level.
  const std::vector<std::vector<firmware::RawSample>>& codes() const { return codes_; }
  const firmware::BatchTable& table() const { return core_->table(); }
  const firmware::CoreConfiguration& configuration() const { return configuration_; }
  const host_sim::Scenario& scenario() const { return scenario_; }

 private:
  void draw(uint64_t seed, bool noisy);
  void fit_derived_signals();

  host_sim::Scenario scenario_;
  std::vector<host_sim::Record> clean_, noisy_;  // measured part and the core's margin
  std::vector<std::vector<firmware::RawSample>> codes_;
  std::vector<std::vector<double>> deviation_;  // of the noise, per level and channel
  std::vector<rig_file::ChannelCalibration> calibrations_;
  firmware::CoreConfiguration configuration_;
  std::unique_ptr<firmware::EstimatorCore> core_;
  uint32_t next_sequence_ = 0;  // samples are counted on over levels and runs
};

}  // namespace accuracy
