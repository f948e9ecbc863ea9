// What a program uses of the core, for the size of its code: the linker drops the rest.
#include "firmware/estimator_core.hpp"

firmware::CoreConfiguration configuration;

extern "C" const firmware::Estimates& entry(firmware::EstimatorCore& core, const firmware::RawSample& sample) {
  core.begin_level();
  core.push(sample);
  core.end_level();
  core.reset();
  return core.solve();
}

struct Placed {
  firmware::EstimatorCore core{configuration};
};
Placed placed;
