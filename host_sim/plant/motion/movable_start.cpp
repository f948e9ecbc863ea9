#include "host_sim/plant/motion/movable_start.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

constexpr double kFinest = 1e-6;       // of a state's size: no sensor tells it better
constexpr double kSlopeOfNoise = 2.5;  // the slope of a parabola through three samples at its end, per noise and sample

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

MovableStart::MovableStart(const FreeRun& run, const Misfit& misfit, size_t sample, InitialState measured)
    : run_(run), misfit_(misfit), sample_(sample), measured_(std::move(measured)) {
  const Record first = run_.samples(sample_, measured_, misfit_.samples());
  missed_ = misfit_.of(first);
  take_sizes(first);
  take_firmness(first.sample_period_s);
}

InitialState MovableStart::moved(const Eigen::VectorXd& by) const {
  InitialState state = measured_;
  for (size_t i = 0; i < state.x_m.size(); ++i) {
    const Eigen::Index x = static_cast<Eigen::Index>(i), v = x + static_cast<Eigen::Index>(state.x_m.size());
    state.x_m[i] += by[x] * size_[x];
    state.v_m_s[i] += by[v] * size_[v];
  }
  return state;
}

std::optional<Eigen::VectorXd> MovableStart::missed_from(const Eigen::VectorXd& by) const {
  try {
    return misfit_.of(run_.samples(sample_, moved(by), misfit_.samples()));
  } catch (const PlantError&) {
    return std::nullopt;
  }
}

// The larger of what the run and the record show of it; what neither shows has the size of the largest of its kind.
void MovableStart::take_sizes(const Record& first) {
  const Eigen::Index n = static_cast<Eigen::Index>(measured_.x_m.size());
  size_.resize(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int dof = static_cast<int>(i + 1);
    const Sizes shown = misfit_.sizes(dof);
    size_[i] = std::max(rms(first.find(Quantity::kDisplacement, dof)->values), shown.x_m);
    size_[n + i] = std::max(rms(first.find(Quantity::kVelocity, dof)->values), shown.v_m_s);
  }
  for (auto kind : {size_.head(n), size_.tail(n)}) {
    const double largest = kind.maxCoeff();
    for (double& size : kind)
      if (size == 0.0) size = largest;
  }
}

void MovableStart::take_firmness(double period_s) {
  const Eigen::Index n = static_cast<Eigen::Index>(measured_.x_m.size());
  firmness_ = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int dof = static_cast<int>(i + 1);
    const double x_m = misfit_.noise(Quantity::kDisplacement, dof), v_m_s = misfit_.noise(Quantity::kVelocity, dof);
    hold(i, x_m);
    hold(n + i, std::isnan(v_m_s) ? kSlopeOfNoise * x_m / period_s : v_m_s);
  }
}

void MovableStart::hold(Eigen::Index state, double noise) {
  if (std::isnan(noise) || !(size_[state] > 0.0)) return;
  firmness_[state] = std::pow(size_[state] / std::max(noise, kFinest * size_[state]), 2);
}

}  // namespace host_sim
