#include "host_sim/programs/estimate/drive_frequency.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

constexpr double kCycles = 8.0, kMost = 0.5;
constexpr int kHarmonics = 7;
constexpr double kTwoPi = 6.283185307179586;

// The mean, and cosine and sine of every harmonic that half the sampling rate holds.
Eigen::MatrixXd harmonics(Eigen::Index samples, double cycles_per_sample) {
  const int count = std::clamp(static_cast<int>(0.45 / cycles_per_sample), 1, kHarmonics);
  Eigen::MatrixXd columns(samples, 2 * count + 1);
  for (Eigen::Index k = 0; k < samples; ++k) {
    columns(k, 0) = 1.0;
    for (int h = 1; h <= count; ++h) {
      const double angle = kTwoPi * h * cycles_per_sample * static_cast<double>(k);
      columns(k, 2 * h - 1) = std::cos(angle), columns(k, 2 * h) = std::sin(angle);
    }
  }
  return columns;
}

double squares_about_mean(const Eigen::VectorXd& y) { return (y.array() - y.mean()).square().sum(); }

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

// The channel of each kind that moves most; a drive before the motion that it makes.
const Channel* driving(const Record& record) {
  const Channel* most = nullptr;
  double most_squares = 0.0;
  const auto rank = [](const Channel& c) { return c.quantity == Quantity::kForce ? 2 : is_drive(c) ? 1 : 0; };
  for (const Channel& channel : record.channels) {
    const double squares = squares_about_mean(vector_of(channel.values));
    if (squares == 0.0) continue;
    if (most == nullptr || rank(channel) > rank(*most) ||
        (rank(channel) == rank(*most) && channel.quantity == most->quantity && squares > most_squares))
      most = &channel, most_squares = squares;
  }
  return most;
}

}  // namespace

double share_at(const std::vector<double>& values, double sample_period_s, double frequency_Hz) {
  const double cycle = 1.0 / (frequency_Hz * sample_period_s);
  const auto length = static_cast<Eigen::Index>(std::min(kCycles * cycle, static_cast<double>(values.size())));
  if (static_cast<double>(length) < cycle) return 0.0;
  const Eigen::MatrixXd columns = harmonics(length, 1.0 / cycle);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(columns);
  const auto y = vector_of(values);
  double missed = 0.0, whole = 0.0;
  for (Eigen::Index first = 0; first + length <= y.size(); first += length) {
    const Eigen::VectorXd part = y.segment(first, length);
    missed += (part - columns * factors.solve(part)).squaredNorm();
    whole += squares_about_mean(part);
  }
  return whole > 0.0 ? 1.0 - missed / whole : 0.0;
}

std::vector<std::string> doubt_frequency(const std::vector<Record>& records, double frequency_Hz) {
  std::vector<std::string> notes;
  for (const Record& record : records) {
    const Channel* drive = driving(record);
    if (drive == nullptr) continue;
    const double share = share_at(drive->values, record.sample_period_s, frequency_Hz);
    if (share >= kMost) continue;
    notes.push_back(
        fmt::format("{}: --frequency says {:g} Hz, and {:.0f} % of the power of {} lies there and at its multiples: "
                    "windows of whole cycles of what the drive has not are too few and say too little, leave it out",
                    record.file, frequency_Hz, 100.0 * std::max(0.0, share), drive->name));
  }
  return notes;
}

}  // namespace host_sim
