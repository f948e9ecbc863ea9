// Decides how every signal of the energy equations is made from the channels a rig has: measured, derived, delayed, filtered.
//
//   all of x, v (and a) measured, no delays   codes as they are
//   x and a                                   v fused of both, nothing else filtered (configuration.hpp)
//   only x                                    v and a by differences, every channel through the same low-pass (to a tenth of the sample
//                                             rate; to 0.23 where a recording shows that the motion reaches beyond that)
//   v without x                               x by integration, every channel through the same high-pass (0.16 Hz at 1 kHz)
//   only a                                    v and x by integration, likewise (1.2 Hz at 1 kHz)
//   delays (rig file's [[channel]] delay_us)  fractional shift of the late channel
// The DOFs may differ: what one of them needs is applied to all channels, so that each equation sees one band and one delay.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"

namespace rig_file {

// Largest magnitude of each signal in SI units; 0 where not known (then a bound from full scale and band is taken, which
// costs resolution). A signal has 22 bits for it and one to spare.
struct SignalRanges {
  double largest[firmware::kMaxNodes][firmware::kQuantities] = {};
  NodeNoise noise;                                  // in codes
  double moving_samples[firmware::kMaxNodes] = {};  // of the displacement, moving_samples.hpp; 0: not known
  // Octaves from the sample rate down to the slowest motion, where the high-pass may go up to it; nothing: its corner is as configured.
  std::optional<int> octaves_to_slowest_motion;
  double fastest_Hz = 0.0;  // no motion is faster; 0: not known
  bool wide_band =
      false;  // a displacement moves beyond a tenth of the sample rate: where it is differentiated, pass more of it
};

// Fills configuration.signals and the high-pass from configuration.channels, links and terms.
// Throws RigFileError where a DOF has too few channels for its equation.
void plan_signals(firmware::CoreConfiguration& configuration, const SignalRanges& ranges = {});

// kAsConfigured: the same for every motion, as on a board, which has not seen it yet. kBelowMotion: it follows a fast motion up.
enum class Corner { kAsConfigured, kBelowMotion };

// What the signals of a planned configuration reach on recorded samples, one vector per record.
SignalRanges measure_ranges(const firmware::CoreConfiguration& planned,
                            const std::vector<std::vector<firmware::RawSample>>& records,
                            Corner corner = Corner::kAsConfigured);

// Does any signal of a planned configuration pass a filter? Then all do. Where none does, recorded samples tell the plan no more than
// whether the noise of a displacement has a colour (channel_noise.hpp).
bool filtered(const firmware::CoreConfiguration& planned);

// Is any signal of a planned configuration the slope of another one?
bool differentiates(const firmware::CoreConfiguration& planned);
// An acceleration, of a displacement?
bool differentiates_twice(const firmware::CoreConfiguration& planned);

// Is any the integral of another one?
bool integrates(const firmware::CoreConfiguration& planned);

// The plan in one line: "velocity and acceleration of DOF 1 derived from displacement; ..." Empty: all measured.
std::string describe_plan(const firmware::CoreConfiguration& planned);

}  // namespace rig_file
