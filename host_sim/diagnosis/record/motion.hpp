// One record made ready for the diagnosis: per DOF the windowed spectra of what was measured, the noise of each channel,
// and one consistent motion (x, v, a) fused from all of them.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fourier.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace diagnosis {

// A record cannot answer the question; what() says why and what to measure instead. Programs exit with 3.
struct CannotAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr int kMotionQuantities = 3;  // displacement, velocity, acceleration, in this order

// Spectra of g x, (g x)', (g x)'' for the outer ramp g, each from its own channel.
struct DofSpectra {
  std::array<bool, kMotionQuantities> measured{};
  std::array<std::string, kMotionQuantities> channel;
  std::array<Spectrum, kMotionQuantities> z;
  std::array<Series, kMotionQuantities> noise;  // per bin: variance of the channel's error per sample (white: constant)
  bool any() const { return measured[0] || measured[1] || measured[2]; }
  int count() const { return measured[0] + measured[1] + measured[2]; }
  size_t first() const {
    return measured[0] ? 0 : measured[1] ? 1 : 2;
  }  // quantity that is measured; the only one where count() is 1
};

struct DofMotion {
  bool measured = false;
  Series x, v, a;                       // fused; right where the outer ramp is 1
  Series smooth_x, smooth_v, smooth_a;  // with the least expected error, for functions that are not linear
  Spectrum raw;                         // fused displacement under the outer weight
  Series trust;                         // per bin: share of the raw spectrum in the smooth signals
  Series variance;                      // per bin: variance of the displacement error per sample
  double smooth_v_error = 0;            // standard deviation of smooth_v
};

// A force between its samples: smooth, straight from one to the next, or each held until the next.
enum class Hold { kSmooth, kLinear, kSteps };

struct FusedRecord {
  std::string file;
  size_t samples = 0;
  double period_s = 0;
  std::shared_ptr<Fourier> fourier;
  Ramp outer;
  Series inner;                              // weight of the equation rows: zero where the outer ramp is not 1
  double inner_energy = 0;                   // sum of inner^2
  bool coarse = false;                       // a channel takes few values: its rounding errors follow the motion
  Eigen::Index first_bin = 0, last_bin = 0;  // bins of the equation rows
  double slow_Hz = 0;                        // what is integrated may drift below it
  std::vector<DofSpectra> spectra;           // per DOF, then the base
  std::vector<DofMotion> motion;             // per DOF, then the base
  std::vector<Series> force;                 // per DOF; empty where not measured
  Hold hold = Hold::kSmooth;                 // of the forces
  std::vector<size_t> held;                  // DOFs whose force comes in steps
  double hold_doubt_s = 0;                   // standard deviation of the delay that its correction may have left
  std::vector<Series> force_noise;           // per bin: variance per sample; empty where not measured
  double bin_Hz() const { return 1.0 / (static_cast<double>(samples) * period_s); }
  Eigen::Index first_beyond(double hertz) const { return static_cast<Eigen::Index>(std::ceil(hertz / bin_Hz())); }
  double omega(Eigen::Index bin) const { return 6.283185307179586 * static_cast<double>(bin) * bin_Hz(); }
};

// Transforms every channel. Throws CannotAnswer where a DOF of the rig has no motion channel or the record is too short.
FusedRecord read_record(const rig_file::RigModel& rig, const host_sim::Record& record, double top_of_band);

// Spectra of what is measured of a DOF under the outer ramp. Inside the ramps they want the displacement too: where only its
// derivatives are measured it is integrated, with constants that leave the least slow motion.
DofSpectra transform(const host_sim::Record& record, int dof, const FusedRecord& f);

// First bin below which this share of the velocities' power lies.
Eigen::Index motion_bin(const FusedRecord& record, double share);

// (jw)^quantity: what turns the spectrum of a displacement into that of a velocity or an acceleration.
Complex derivative(double omega, int quantity);

// Noise of each motion channel from the record itself.
void estimate_noise(FusedRecord& record);

// One motion per DOF from all its channels, each weighted by its noise.
void fuse(FusedRecord& record);

}  // namespace diagnosis
