// Motion of a true rig: Runge-Kutta of order four in fixed substeps; every velocity reversal of a link with dry friction is
// located inside its substep and ends in sticking (rate held at zero by the friction that this takes, until that exceeds
// the link's level) or in sliding the other way. Written for the tests alone: shares no code with what they judge.
#pragma once
#include "true_rig.hpp"

namespace hidden_rig {

// What acts on the rig, at half substeps: entry [2 * substeps * sample + j]. A DOF without force has an empty row.
struct Drive {
  int substeps = 4;
  double sample_period_s = 1e-3;
  std::vector<Values> force_N;
  Values base_x, base_v, base_a;         // empty: no moving base
  bool held = false;                     // the force stays at its sample until the next one
  std::vector<double> start_x, start_v;  // per DOF; empty: at rest
};

struct Motion {  // one row per DOF or link, one value per sample
  std::vector<Values> x, v, a;
  std::vector<Values> damping_force;  // per link: c w + friction
  std::vector<Values> rate;           // per link
  std::vector<Values> hidden_force;   // per effect; empty for faults of the measurement
  std::vector<double> stuck_share;    // per link
};

// `skip` samples are simulated first and dropped. Viscous coefficients are multiplied by viscous_scale (one per link, or
// empty), as by the temperature of one record.
Motion integrate(const TrueRig& rig, const Drive& drive, size_t samples, size_t skip,
                 const std::vector<double>& viscous_scale = {});

}  // namespace hidden_rig
