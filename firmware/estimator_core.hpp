// The whole numeric path behind one door: raw samples in, estimates out. No clock, no bus, no operating system.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

struct CoreHealth {
  uint32_t samples = 0;
  uint32_t missed_samples = 0;      // gaps in RawSample::sequence
  uint32_t saturated_samples = 0;   // samples with a channel at its full scale
};

class EstimatorCore {
 public:
  explicit EstimatorCore(const CoreConfiguration& configuration);
  void reset();                         // forgets all levels
  void begin_level();                   // a new excitation level or record: filters and sums restart
  void push(const RawSample& sample);   // constant cost per sample on average; work is done every kBlockSamples samples
  void end_level();                     // closes the window
  const Estimates& solve();             // from everything since reset()
  const CoreHealth& health() const;
};

}  // namespace firmware
