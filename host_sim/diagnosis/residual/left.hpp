// What a model leaves of its windows, and how much of that noise may be.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// Whether what is left goes with the motion of its own window, or as well with that of any other: with_motion().
struct WithMotion {
  bool known = false;  // false: too few windows, too short ones, or nothing beyond the level beside the motion's band
  double share = 0;    // of the squared residual, corrected for chance
  double std = 0;      // of `share`, from its scatter between windows
  double z = 0;        // of its mean over windows, as a normal deviate
};

// Noise does not know how loud the motion is: how the error of windows goes with their motion.
struct WithLoudness {
  double z = 0;            // of the correlation of both logarithms, as a normal deviate
  double quiet_share = 1;  // of the squared residual, that would be left if all windows were as the quieter quarter
};

// A channel's line at the mains' frequency.
struct Hum {
  double hertz = 0, amplitude = 0;  // 0: none; of the channel, SI units
  double over = 0;                  // the level around
  bool driven = false;              // something drives the rig there: a model's error may look so
};

// What is left, channel by channel.
struct Left {
  Vec noise;         // mean square of what looks like noise: the level above the motion's band
  Vec sensor_noise;  // of that what the drives' noise does not make of it
  Vec in_band;       // residual's level in the band of the motion over that beside it
  // Highest single line of a residual's spectrum in that band over the level around it, mains left out; and that of
  // those at which nothing drives the rig.
  double line = 0, foreign_line = 0;
  std::vector<Hum> hum;
  WithMotion with_motion;
  WithLoudness with_loudness;
  double worst() const { return in_band.size() ? in_band.maxCoeff() : 0; }
};
// Whether more than noise is left: more in the band of the motion than beside it, and not of a colour that noise may
// have.
bool beyond_noise(const Left& left);
// Whether numbers beside named causes are not vouched for: more than noise is left, or more than white noise makes by far and two
// deviations say that it goes with the motion.
bool may_bend_numbers(const Left& left);

// Share of a fit's squared residual that looks like noise, mean over the channels.
double noise_share(const Left& left, const Fitted& fit);
Left left_by(const System& system, const std::vector<Prepared>& records, const State& state);

}  // namespace diagnosis::runs
