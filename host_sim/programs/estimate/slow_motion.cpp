#include "host_sim/programs/estimate/slow_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/rig_file/channel_noise.hpp"

namespace host_sim {
namespace {

constexpr int kDisplacement = static_cast<int>(Quantity::kDisplacement);
// Means of twice as many samples would still show nothing but white noise in the upper half of their spectrum.
constexpr size_t kMargin = 2;
constexpr size_t kFewestMeans = 1024;  // in all records: what an interval needs
constexpr double kReadable = 0.5;      // doubt of a noise that is read well

bool displacement_alone(const Record& record) {
  bool any = false;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kVelocity || channel.quantity == Quantity::kAcceleration) return false;
    any = any || channel.quantity == Quantity::kDisplacement;
  }
  return any;
}

std::vector<double> means(const std::vector<double>& values, size_t size) {
  std::vector<double> result(values.size() / size);
  for (size_t n = 0; n < result.size(); ++n) {
    double sum = 0;
    for (size_t i = 0; i < size; ++i) sum += values[n * size + i];
    result[n] = sum / static_cast<double>(size);
  }
  return result;
}

size_t samples(const std::vector<Record>& records) {
  size_t sum = 0;
  for (const Record& record : records) sum += record.samples();
  return sum;
}

// Does the upper half of the spectrum of these means hold noise alone?
bool noise_alone(const std::vector<Record>& records, size_t channel, size_t size) {
  double largest = 0;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) largest = std::max(largest, std::fabs(value));
  if (largest == 0) return false;
  std::vector<std::vector<firmware::RawSample>> codes;
  for (const Record& record : records) {
    const std::vector<double> mean = means(record.channels[channel].values, size);
    std::vector<firmware::RawSample> made(mean.size());
    for (size_t n = 0; n < mean.size(); ++n)
      made[n].code[0][kDisplacement] = static_cast<int32_t>(std::lround(mean[n] / largest * 0x1p30));
    codes.push_back(std::move(made));
  }
  const rig_file::ChannelNoise noise = rig_file::read_noise(codes, 0, kDisplacement, 1.0);
  return noise.deviation > 0 && noise.white() && noise.doubt < kReadable;
}

size_t largest_mean(const std::vector<Record>& records) {
  size_t size = 1;
  const auto allowed = [&](size_t next) {
    if (samples(records) / next < kFewestMeans) return false;
    for (size_t c = 0; c < records.front().channels.size(); ++c)
      if (records.front().channels[c].quantity == Quantity::kDisplacement && !noise_alone(records, c, next))
        return false;
    return true;
  };
  if (!allowed(1)) return 1;
  while (allowed(size + std::max<size_t>(1, size / 4))) size += std::max<size_t>(1, size / 4);
  return size / kMargin;
}

}  // namespace

std::string average_slow_motion(SharedRecords& shared) {
  if (shared.get().empty() || !displacement_alone(shared.get().front())) return {};
  const size_t size = largest_mean(shared.get());
  if (size < 2) return {};
  std::vector<Record>& records = shared.own();
  for (Record& record : records) {
    for (Channel& channel : record.channels) channel.values = means(channel.values, size);
    record.start_s += 0.5 * static_cast<double>(size - 1) * record.sample_period_s;
    record.sample_period_s *= static_cast<double>(size);
  }
  return fmt::format("the motion is slow: taken as means of {} samples, {:.4g} Hz, which have less noise", size,
                     1.0 / records.front().sample_period_s);
}

}  // namespace host_sim
