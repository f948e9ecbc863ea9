// Forces and base motions as functions of time that can be evaluated at any t, as an integrator with free steps needs.
#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace host_sim {

// Value with its first two time derivatives: for a base motion displacement, velocity, acceleration.
struct Motion {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

// A stretch of a signal as a polynomial: between two knots.
struct SignalPiece {
  double start_s = 0.0, period_s = 1.0;
  double number = -1.0;  // of the knot that it begins at; -1: none
  double c[6] = {};      // c0 + s (c1 + s (c2 + s (c3 + s (c4 + s c5)))), s = (t - start) / period - number
  // Is the time strictly behind the first knot of all, and within this piece?
  bool holds(double position) const { return position > 0.0 && position >= number && position < number + 1.0; }
  double value(double position) const {
    const double s = position - number;
    return c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
  }
};

class Signal {
 public:
  virtual ~Signal() = default;
  virtual double value(double t_s) const = 0;
  virtual Motion motion(double t_s) const = 0;
  // The piece that holds this time, with the same values to the last bit; false: there is none, value() is to be asked.
  virtual bool piece_at(double /*t_s*/, SignalPiece& /*piece*/) const { return false; }
  // From this time on the signal is its Taylor series up to the time returned; t_s itself: it has none.
  virtual double smooth_until(double t_s) const { return t_s; }
  // The first `count` coefficients of that series: value(t_s + theta step_s) = sum of c[k] theta^k. Returns how many of them may
  // differ from zero.
  virtual int expand(double /*t_s*/, double /*step_s*/, int /*count*/, double* /*c*/) const { return 0; }
  virtual double peak()
      const = 0;  // largest magnitude (or a bound near it): sets error scales before anything has moved
};
using SignalPtr = std::shared_ptr<const Signal>;

// Reads a signal at times that lie close to each other: a piece is worked out once.
class SignalReader {
 public:
  explicit SignalReader(SignalPtr signal) : signal_(std::move(signal)) {}
  double value(double t_s) {
    const double position = (t_s - piece_.start_s) / piece_.period_s;
    if (piece_.number >= 0.0 && piece_.holds(position)) return piece_.value(position);
    if (!signal_->piece_at(t_s, piece_)) return piece_.number = -1.0, signal_->value(t_s);
    return piece_.value((t_s - piece_.start_s) / piece_.period_s);
  }

 private:
  SignalPtr signal_;
  SignalPiece piece_;
};

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
