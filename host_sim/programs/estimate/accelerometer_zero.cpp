#include "host_sim/programs/estimate/accelerometer_zero.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace host_sim {
namespace {

constexpr size_t kBlocks = 8;
constexpr size_t kFewestSamples = 64;  // of a block
constexpr double kBeyondChance =
    7.0;  // standard errors of eight blocks: Student's t with 7 degrees of freedom, 1 in 5000
constexpr double kPi = 3.14159265358979323846;

// Sine and cosine of a turn over so many samples, in the middle of each.
struct Turn {
  explicit Turn(size_t count) : phase_step(2.0 * kPi / static_cast<double>(count)), sine(count), cosine(count) {
    for (size_t i = 0; i < count; ++i) {
      const double phase = phase_step * (static_cast<double>(i) + 0.5);
      sine[i] = std::sin(phase), cosine[i] = std::cos(phase);
    }
  }
  double phase_step;
  std::vector<double> sine, cosine;
};

// The last one that was asked for is kept: all channels of a record are as long.
const Turn& turn_over(size_t count) {
  thread_local std::optional<Turn> turn;
  if (!turn || turn->sine.size() != count) turn.emplace(count);
  return *turn;
}

// From sample `first` on, with w = sin^2(pi t / T), which vanishes with its slope at both ends: int w a dt =
// -int w' v dt = int w'' x dt for what moves there, whatever it does; the rest of int w a dt is the zero's, times T / 2.
double zero_over(const Channel& acceleration, const Channel& motion, double step_s, size_t first, const Turn& turn) {
  const double rate = turn.phase_step / step_s;
  const size_t count = turn.sine.size();
  double sum = 0.0;
  for (size_t i = 0; i < count; ++i) {
    const double y = motion.values[first + i];
    sum += 0.5 * (1.0 - turn.cosine[i]) * acceleration.values[first + i];
    sum += motion.quantity == Quantity::kVelocity ? 0.5 * rate * turn.sine[i] * y
                                                  : -0.5 * rate * rate * turn.cosine[i] * y;
  }
  return sum / (0.5 * static_cast<double>(count));
}

// 0: none beyond chance.
double zero_of(const Record& record, const Channel& acceleration, const Channel& motion) {
  const size_t count = record.samples() / kBlocks;
  if (count < kFewestSamples) return 0.0;
  const Turn& turn = turn_over(count);
  double sum = 0.0, squares = 0.0;
  for (size_t block = 0; block < kBlocks; ++block) {
    const double zero = zero_over(acceleration, motion, record.sample_period_s, block * count, turn);
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
