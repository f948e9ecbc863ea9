// What a free motion swings about.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace host_sim {

// The mean of a displacement, weighted with the square of its speed over a quarter of a period, so that what stands still does not count, and with a bell over each
// stretch, so that parts of a period at its ends do not.
class Swing {
 public:
  void add(const std::vector<double>& y) { add(y, 0, y.size()); }
  void add(const std::vector<double>& y, size_t from, size_t to);
  double mean() const { return weights_ > 0 ? sum_ / weights_ : 0; }
  double rms() const;  // about the mean, weighted alike

 private:
  double sum_ = 0, squares_ = 0, weights_ = 0;
};

// How often it goes from half the rms below its mean to half the rms above: noise about the mean is no swing.
size_t clear_swings(const std::vector<double>& y);

// How far the centre of a free decay's first half, quarter and eighth, as long as they hold three swings, lies from that of all: in a decay of a
// few swings the parts of periods at the ends move it by a good part of the amplitude. 0 where there are too few swings to tell.
double strays_by(const std::vector<double>& y);

// Where it stays at its end, in the last quarter; nothing where it still moves there.
std::optional<double> stays_at(const std::vector<double>& y);

// Where the centre of the swings of free decays would be at no amplitude, if it moves with the square of the amplitude: a spring k u +
// k2 u^2 swings about -k2 a^2 / 2k. From stretches of some periods each; nothing where there are fewer than four of them, or where their
// amplitudes are within a factor of 1.4.
std::optional<double> centre_of_small_swings(const std::vector<const std::vector<double>*>& records);

}  // namespace host_sim
