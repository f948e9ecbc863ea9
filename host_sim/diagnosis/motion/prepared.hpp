// A record made ready for simulation: every channel low-passed and thinned out to what its motion needs, and a first
// guess of displacement, velocity and acceleration of every DOF.
#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../band/kept_finer.hpp"
#include "../record/series.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace diagnosis::runs {

using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr Index kLeast = 100;  // samples of motion that a record is judged by

struct MotionTrace {
  int dof = 0;       // from 0
  int quantity = 0;  // 0 displacement, 1 velocity, 2 acceleration
  std::string channel;
  Vec y;                 // SI units
  double step = 0;       // in which its values change, an encoder's; 0: none shows
  bool travels = false;  // a displacement that runs on: its motion is what is off a straight line, which needs no force
  double rounding_variance() const { return step * step / 12; }
};

struct Guess {  // of one DOF; base: after the last DOF
  bool given = false;
  Vec x, v, a;
};

// A moving base of which nothing but accelerations is known, in a rig that touches no ground, is left where it is: the
// DOFs move against it, under its inertial forces. Its displacement, which would have to be integrated twice, is not needed.
struct Base {
  std::array<Vec, 3> reading;  // displacement, velocity, acceleration; empty: not measured
  Index slow_half = 0;         // samples that the drift of what is integrated is averaged over, either way
  bool ridden = false;  // displacements and velocities of DOFs are against it; accelerations are against the ground
  bool given() const { return reading[0].size() + reading[1].size() + reading[2].size() > 0; }
};

struct Prepared {
  std::string file;
  double step_s = 0;
  double read_every_s = 0;  // of the record, before it was thinned out
  // Of this record, counted from the mean of all, as if no time had passed between them: what changes from record to
  // record has its mean as the coefficient, which is what a rig file can state.
  double middle_s = 0;
  Index samples = 0;
  double period_s = 0;  // of the motion: 2 pi rms(x) / rms(v), of what runs on off its line
  double top_Hz = 0;    // highest frequency of the motion
  std::vector<MotionTrace> traces;
  std::vector<Vec> force;  // per DOF; empty: none
  // Per DOF: of a force that is nought between blows, or switches between a few values, the standard deviation of its noise, sample by
  // sample; empty: as noise_level().
  std::vector<Vec> noise_in_blows;
  std::vector<Guess> guess;
  Base base;
  bool held = false;        // its forces stay at their samples until the next ones
  double rounded_over = 0;  // samples over which accelerometers round a jump (rounding.hpp); 0: they do not
  std::shared_ptr<KeptFiner> between_samples = std::make_shared<KeptFiner>();  // its drives
  Index smooth_half = 0, slow_half = 0;  // samples that the guesses are smoothed over, and their drift taken off
  double time_s(Index sample) const { return static_cast<double>(sample) * step_s; }
};

// The reading of that quantity of a DOF, from 0; nullptr: not measured.
const MotionTrace* trace_of(const Prepared& record, int dof, int quantity);

// Sum of squares of the motion of a stretch: about its mean. Of a place that travels it is what is off its line, or what the record's speed,
// rms about its mean, would make of a period as long as the stretch: at constant speed nothing moves it off its line.
double motion_square(const Prepared& record, const MotionTrace& trace, Index from, Index length);

// Throws CannotAnswer where a DOF has no motion channel or the record is too short.
Prepared prepare(const rig_file::RigModel& rig, const host_sim::Record& record);
// All records at one step: that of the fastest motion among them.
std::vector<Prepared> prepare_all(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                                  const std::vector<host_sim::Record>& holdout);

// The guesses of all DOFs and of the base from their readings, and the motion's period. Throws CannotAnswer where a DOF has no
// motion channel.
void renew_motion(Prepared& record);
// The base's slow_half, from the slowest motion in its readings.
void tell_drift(Prepared& record);
// The guess of the base from its readings.
void renew_base(Prepared& record);

// Without any mass the force is not what drives the motion but what answers it.
using vocabulary::massless;

// Sum of squares of white noise in `y`, from its third differences: they have 20 times its variance (1 + 9 + 9 + 1). Over
// size - 3 values.
double white_noise_sum(const Vec& y);

constexpr double kNoiseReaches = 4;  // standard deviations: two neighbours beyond are one in 10^8

// Standard deviation of a drive channel's noise: white at the level of the top of its band (what drives may act above the
// motion's band, and a thinned record ends early). 0 for a channel of noughts.
double noise_level(const Vec& drive);
// Of a DOF's force, sample by sample; and where it acts.
Vec noise_along_force(const Prepared& record, size_t dof);
double noise_of_force(const Prepared& record, size_t dof);

}  // namespace diagnosis::runs
