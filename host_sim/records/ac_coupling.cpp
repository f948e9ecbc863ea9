#include "host_sim/records/ac_coupling.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace host_sim {
namespace {

constexpr double kTwoPi = 6.283185307179586;

// Legendre's polynomials up to the second, on -1 .. 1: nearly orthogonal over evenly spaced samples.
std::array<double, 3> parabola_terms(double t) { return {1.0, t, 0.5 * (3.0 * t * t - 1.0)}; }

// The sum of squares of a polynomial over n samples is n / (2 degree + 1), to 1/n. Taken off twice: the second time what
// the first has left.
void take_off_parabola(std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  const auto at = [&](size_t i) { return (2.0 * static_cast<double>(i) + 1.0) / n - 1.0; };
  for (int pass = 0; pass < 2; ++pass) {
    std::array<double, 3> sums{};
    for (size_t i = 0; i < values.size(); ++i)
      for (size_t k = 0; k < 3; ++k) sums[k] += values[i] * parabola_terms(at(i))[k];
    for (size_t i = 0; i < values.size(); ++i)
      for (size_t k = 0; k < 3; ++k)
        values[i] -= sums[k] * (2.0 * static_cast<double>(k) + 1.0) / n * parabola_terms(at(i))[k];
  }
}

}  // namespace

std::vector<double> before_ac_coupling(const std::vector<double>& reading, double corner_Hz, double sample_period_s) {
  const double mean = std::accumulate(reading.begin(), reading.end(), 0.0) / static_cast<double>(reading.size());
  const double half_step = 0.5 * kTwoPi * corner_Hz * sample_period_s;
  std::vector<double> kept_back(reading.size(), 0.0);
  for (size_t i = 1; i < reading.size(); ++i)
    kept_back[i] = kept_back[i - 1] + half_step * (reading[i - 1] + reading[i] - 2.0 * mean);
  take_off_parabola(kept_back);
  for (size_t i = 0; i < reading.size(); ++i) kept_back[i] += reading[i];
  return kept_back;
}

double share_taken(const std::vector<double>& reading, double corner_Hz, double sample_period_s) {
  const std::vector<double> before = before_ac_coupling(reading, corner_Hz, sample_period_s);
  double taken = 0.0, left = 0.0;
  for (size_t i = 0; i < before.size(); ++i) {
    taken += (before[i] - reading[i]) * (before[i] - reading[i]);
    left += reading[i] * reading[i];
  }
  return left > 0.0 ? std::sqrt(taken / left) : 0.0;
}

void undo_ac_coupling(const std::vector<AcCoupling>& couplings, std::vector<Record>& records) {
  for (Record& record : records)
    for (Channel& channel : record.channels)
      for (const AcCoupling& coupling : couplings)
        if (coupling.channel == channel.name && coupling.corner_Hz > 0.0)
          channel.values = before_ac_coupling(channel.values, coupling.corner_Hz, record.sample_period_s);
}

std::vector<AcCoupling> stated_ac_couplings(const rig_file::RigModel& model) {
  std::vector<AcCoupling> list;
  for (const rig_file::ChannelEntry& entry : model.channels)
    if (entry.ac_coupling_Hz > 0.0) list.push_back({entry.name, entry.ac_coupling_Hz});
  return list;
}

}  // namespace host_sim
