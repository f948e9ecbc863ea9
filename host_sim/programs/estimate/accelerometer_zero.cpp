#include "host_sim/programs/estimate/accelerometer_zero.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace host_sim {
namespace {

constexpr size_t kBlocks = 8;
constexpr size_t kFewestSamples = 64;  // of a block
constexpr double kBeyondChance =
    7.0;  // standard errors of eight blocks: Student's t with 7 degrees of freedom, 1 in 5000
constexpr double kPi = 3.14159265358979323846;

// Over samples first .. first + count - 1, with w = sin^2(pi t / T), which vanishes with its slope at both ends: int w a dt =
// -int w' v dt = int w'' x dt for what moves there, whatever it does; the rest of int w a dt is the zero's, times T / 2.
double zero_over(const Channel& acceleration, const Channel& motion, double step_s, size_t first, size_t count) {
  const double turn = 2.0 * kPi / static_cast<double>(count), rate = turn / step_s;
  double sum = 0.0;
  for (size_t i = 0; i < count; ++i) {
    const double phase = turn * (static_cast<double>(i) + 0.5), y = motion.values[first + i];
    sum += 0.5 * (1.0 - std::cos(phase)) * acceleration.values[first + i];
    sum += motion.quantity == Quantity::kVelocity ? 0.5 * rate * std::sin(phase) * y
                                                  : -0.5 * rate * rate * std::cos(phase) * y;
  }
  return sum / (0.5 * static_cast<double>(count));
}

// 0: none beyond chance.
double zero_of(const Record& record, const Channel& acceleration, const Channel& motion) {
  const size_t count = record.samples() / kBlocks;
  if (count < kFewestSamples) return 0.0;
  double sum = 0.0, squares = 0.0;
  for (size_t block = 0; block < kBlocks; ++block) {
    const double zero = zero_over(acceleration, motion, record.sample_period_s, block * count, count);
    sum += zero, squares += zero * zero;
  }
  const double mean = sum / kBlocks;
  const double error = std::sqrt(std::max(0.0, squares / kBlocks - mean * mean) / (kBlocks - 1));
  return std::fabs(mean) > kBeyondChance * error ? mean : 0.0;
}

// Of an acceleration that has another motion of its DOF beside it.
double zero_of_channel(const Record& record, const Channel& channel) {
  if (channel.quantity != Quantity::kAcceleration) return 0.0;
  const Channel* motion = record.find(Quantity::kVelocity, channel.dof);
  if (motion == nullptr) motion = record.find(Quantity::kDisplacement, channel.dof);
  return motion == nullptr ? 0.0 : zero_of(record, channel, *motion);
}

}  // namespace

std::vector<std::string> take_off_accelerometer_zeros(SharedRecords& records) {
  std::map<std::string, double> largest;
  for (size_t r = 0; r < records.get().size(); ++r)
    for (size_t c = 0; c < records.get()[r].channels.size(); ++c) {
      const double zero = zero_of_channel(records.get()[r], records.get()[r].channels[c]);
      if (zero == 0.0) continue;
      Channel& channel = records.own()[r].channels[c];
      for (double& value : channel.values) value -= zero;
      double& most = largest[channel.name];
      if (std::fabs(zero) > std::fabs(most)) most = zero;
    }
  std::vector<std::string> notes;
  for (const auto& [name, zero] : largest)
    notes.push_back(fmt::format("{} reads {:.4g} at rest (a part of gravity, or its zero): taken off", name, zero));
  return notes;
}

}  // namespace host_sim
