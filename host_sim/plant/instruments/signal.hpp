// Forces and base motions as functions of time that can be evaluated at any t, as an integrator with free steps needs.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace host_sim {

// Value with its first two time derivatives: for a base motion displacement, velocity, acceleration.
struct Motion {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

class Signal {
 public:
  virtual ~Signal() = default;
  virtual double value(double t_s) const = 0;
  virtual Motion motion(double t_s) const = 0;
  virtual double peak()
      const = 0;  // largest magnitude (or a bound near it): sets error scales before anything has moved
};
using SignalPtr = std::shared_ptr<const Signal>;

// amplitude * cos(2 pi frequency t + phase)
SignalPtr cosine(double amplitude, double frequency_Hz, double phase_rad = 0.0);

struct RandomBand {
  double rms = 1.0;
  double low_Hz = 5.0, high_Hz = 50.0;
};
// Band-limited random signal for start_s <= t <= end_s: equal cosines at the lines low + (k + 1/2) / duration of the
// band with independent random phases, so its rms is that of the band, it does not repeat within the record, and many
// lines make it Gaussian. Tabulated every table_step_s with two exact derivatives, quintic between (C2; off by 2e-8 of
// the peak at 50 Hz, 1 ms).
SignalPtr random_band(const RandomBand& band, double start_s, double end_s, double table_step_s, uint64_t seed,
                      uint64_t stream);

enum class Interpolation {
  kQuintic,  // C2 quintic between samples, derivatives from central differences of up to 9 samples: for band-limited
             // data
  kLinear,
};
// Samples at start_s + k * period_s; the end values hold outside.
SignalPtr sampled(std::vector<double> values, double start_s, double period_s,
                  Interpolation interpolation = Interpolation::kQuintic);

// What drives a rig: one force per DOF (empty or null: none) and the motion of the base (null: at rest).
struct Excitation {
  std::vector<SignalPtr> force_N;
  SignalPtr base_m;
};

}  // namespace host_sim
