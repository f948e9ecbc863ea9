// How large the integral of a channel can become, whatever moves between the channel's rails.
//
// |sum of h[n] code[N - n]| <= sum of |h[n]| * half of the way from rail to rail, h the response of high-pass and integrations: it
// adds up to 0, so the middle between the rails counts as nothing. The bound is reached by a code that jumps from rail to rail with the
// sign of h.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/filter_design.hpp"

namespace rig_file {

struct IntegralBound {
  double integral = 0;  // of what the core's filter takes, in its unit
  double signal = 0;    // behind the filter, in the unit that the impulse makes of that
};

// Of a signal that is integrated, with a high-pass that is chosen and no bits dropped.
IntegralBound integral_bound(const firmware::CoreConfiguration& c, int node, int q, const Impulse& impulse);

}  // namespace rig_file
