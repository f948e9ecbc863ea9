#include "host_sim/plant/motion/misfit.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/rig_model.hpp"

namespace host_sim {
namespace {

constexpr int kSwings = 8;  // of the slowest channel: four periods
constexpr double kRadians = 3.14159265358979 * kSwings;
constexpr size_t kFewest = 16;

using Values = Eigen::Map<const Eigen::ArrayXd>;

Values stretch_of(const Channel& channel, size_t from, size_t count) {
  return {channel.values.data() + from, static_cast<Eigen::Index>(count)};
}

double rms_about_mean(const Values& y) { return std::sqrt((y - y.mean()).square().mean()); }

// Samples until a channel has swung so often from half an rms on one side of its mean to half an rms on the other.
size_t samples_of_swings(const Values& y) {
  const double mean = y.mean(), half = 0.5 * rms_about_mean(y);
  int swings = 0, side = 0;
  for (Eigen::Index k = 0; k < y.size(); ++k) {
    const int now = y[k] > mean + half ? 1 : y[k] < mean - half ? -1 : side;
    if (now != side && side != 0 && ++swings == kSwings) return static_cast<size_t>(k + 1);
    side = now;
  }
  return static_cast<size_t>(y.size());
}

bool moving_body(const Channel& channel) { return channel.quantity != Quantity::kForce && channel.dof >= 1; }

}  // namespace

Misfit::Misfit(const Record& record, size_t from, size_t most) : from_(from) {
  const size_t whole = std::min(most, record.samples() - from);
  for (const Channel& channel : record.channels)
    if (moving_body(channel) && whole > 0)
      count_ = std::max(count_, samples_of_swings(stretch_of(channel, from, whole)));
  count_ = std::min(whole, std::max(count_, kFewest));
  radian_s_ = static_cast<double>(count_) * record.sample_period_s / kRadians;
  for (const Channel& channel : record.channels) {
    if (!moving_body(channel) || count_ == 0) continue;
    const double rms = rms_about_mean(stretch_of(channel, from, count_));
    if (rms > 0.0) readings_.push_back({&channel, rms});
  }
}

Eigen::VectorXd Misfit::of(const Record& run) const {
  const Eigen::Index n = static_cast<Eigen::Index>(count_);
  Eigen::VectorXd out(n * static_cast<Eigen::Index>(readings_.size()));
  Eigen::Index at = 0;
  for (const Reading& reading : readings_) {
    const Channel& channel = *reading.channel;
    Eigen::ArrayXd missed =
        stretch_of(*run.find(channel.quantity, channel.dof), 0, count_) - stretch_of(channel, from_, count_);
    if (channel.quantity == Quantity::kAcceleration) missed -= missed.mean();
    out.segment(at, n) = missed.matrix() / (reading.rms * std::sqrt(static_cast<double>(n)));
    at += n;
  }
  return out;
}

Sizes Misfit::sizes(int dof) const {
  Sizes sizes;
  for (const Reading& reading : readings_) {
    if (reading.channel->dof != dof) continue;
    const double rate_m_s = reading.channel->quantity == Quantity::kDisplacement ? reading.rms / radian_s_
                            : reading.channel->quantity == Quantity::kVelocity   ? reading.rms
                                                                                 : reading.rms * radian_s_;
    sizes.v_m_s = std::max(sizes.v_m_s, rate_m_s);
  }
  sizes.x_m = sizes.v_m_s * radian_s_;
  return sizes;
}

double Misfit::noise(Quantity quantity, int dof) const {
  for (const Reading& reading : readings_) {
    if (reading.channel->quantity != quantity || reading.channel->dof != dof || count_ < 4) continue;
    const Values y = stretch_of(*reading.channel, from_, count_);
    const Eigen::Index n = y.size() - 3;
    const auto third = y.tail(n) - 3.0 * y.segment(2, n) + 3.0 * y.segment(1, n) - y.head(n);
    return std::sqrt(third.square().mean() / 20.0);  // 1 + 9 + 9 + 1
  }
  return std::nan("");
}

}  // namespace host_sim
