#include "host_sim/response/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/response/linear_rig.hpp"

namespace host_sim {
namespace {

constexpr double kTwoSided95 = 1.959963984540054;  // quantile of the normal distribution
// Below this share of the largest |lambda| a pair is a rigid body's: rounding of the eigenvalues of a defective zero
// is the square root of the machine's.
constexpr double kRigidBody = 1e-6;

Mode mode_of(std::complex<double> lambda, const Eigen::VectorXcd& vector, Eigen::Index dofs) {
  Mode mode;
  mode.frequency_Hz = std::abs(lambda) / (2.0 * M_PI);
  mode.damping_ratio = -lambda.real() / std::abs(lambda);
  Eigen::Index largest = 0;
  vector.head(dofs).cwiseAbs().maxCoeff(&largest);
  for (Eigen::Index i = 0; i < dofs; ++i) mode.shape.push_back(vector(i) / vector(largest));
  return mode;
}

double step_of(double value, double std) { return std > 0.0 ? 0.1 * std : 1e-6 * std::max(std::fabs(value), 1e-12); }

// d(frequency), d(damping ratio) of every mode per unknown; empty where the number of modes changes on the way.
struct Slopes {
  std::vector<std::vector<double>> frequency, damping;  // [unknown][mode]
};

// Nought where it is what eigenvalues are rounded to.
double change(double from, double to) { return std::abs(to - from) < 1e-11 * std::abs(to) ? 0.0 : to - from; }

Slopes slopes(const rig_file::RigModel& model, const std::vector<double>& values,
              const std::vector<std::vector<double>>& covariance, size_t modes) {
  Slopes out;
  for (size_t k = 0; k < values.size(); ++k) {
    const double step = step_of(values[k], std::sqrt(std::max(0.0, covariance[k][k])));
    std::vector<double> low = values, high = values;
    low[k] -= step, high[k] += step;
    const std::vector<Mode> below = modes_of(rig_file::with_values(model, low));
    const std::vector<Mode> above = modes_of(rig_file::with_values(model, high));
    if (below.size() != modes || above.size() != modes) return {};
    out.frequency.emplace_back(modes), out.damping.emplace_back(modes);
    for (size_t m = 0; m < modes; ++m) {
      out.frequency[k][m] = change(below[m].frequency_Hz, above[m].frequency_Hz) / (2.0 * step);
      out.damping[k][m] = change(below[m].damping_ratio, above[m].damping_ratio) / (2.0 * step);
    }
  }
  return out;
}

Uncertain with_interval(double value, const std::vector<std::vector<double>>& slope,
                        const std::vector<std::vector<double>>& covariance, size_t mode) {
  double variance = slope.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  for (size_t i = 0; i < slope.size(); ++i)
    if (slope[i][mode] != 0.0 && !(covariance[i][i] > 0.0)) variance = std::numeric_limits<double>::quiet_NaN();
  for (size_t i = 0; i < slope.size(); ++i)
    for (size_t j = 0; j < slope.size(); ++j) variance += slope[i][mode] * covariance[i][j] * slope[j][mode];
  const double half = kTwoSided95 * std::sqrt(variance < 0.0 ? 0.0 : variance);
  return {value, value - half, value + half};
}

}  // namespace

double slowest_mode_Hz(const rig_file::RigModel& model) {
  rig_file::RigModel known = model;
  for (rig_file::Link& link : known.links)
    for (rig_file::Coefficient* c : {&link.stiffness_N_m, &link.gravity_torque_N_m})
      if (c->estimate) *c = {};
  const auto has_mass = [](const rig_file::Dof& dof) { return !dof.mass_kg.estimate && dof.mass_kg.value > 0.0; };
  if (!std::all_of(known.dofs.begin(), known.dofs.end(), has_mass)) return 0.0;
  const LinearRig rig = linear_rig(known);
  const Eigen::VectorXd scale = rig.mass.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd stiffness = scale.asDiagonal() * rig.stiffness * scale.asDiagonal();
  const Eigen::VectorXd squares = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues();
  const double least = squares.minCoeff();
  return least > kRigidBody * squares.maxCoeff() ? std::sqrt(least) / (2.0 * M_PI) : 0.0;
}

std::vector<Mode> modes_of(const rig_file::RigModel& rig) {
  const LinearRig linear = linear_rig(rig);
  if (linear.mass.rows() == 0 || !(linear.mass.diagonal().minCoeff() > 0.0)) return {};
  const Eigen::MatrixXd a = state_space(linear).a;
  if (!a.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  const Eigen::VectorXcd& lambda = solver.eigenvalues();
  const double largest = lambda.cwiseAbs().maxCoeff();
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    if (lambda(i).imag() > kRigidBody * largest)
      modes.push_back(mode_of(lambda(i), solver.eigenvectors().col(i), linear.mass.rows()));
  std::sort(modes.begin(), modes.end(), [](const Mode& x, const Mode& y) { return x.frequency_Hz < y.frequency_Hz; });
  return modes;
}

std::vector<UncertainMode> modes_with_intervals(const rig_file::RigModel& model, const std::vector<double>& values,
                                                const std::vector<std::vector<double>>& covariance) {
  const std::vector<Mode> modes = modes_of(rig_file::with_values(model, values));
  const Slopes slope = slopes(model, values, covariance, modes.size());
  std::vector<UncertainMode> out;
  for (size_t m = 0; m < modes.size(); ++m)
    out.push_back({with_interval(modes[m].frequency_Hz, slope.frequency, covariance, m),
                   with_interval(modes[m].damping_ratio, slope.damping, covariance, m), modes[m].shape});
  return out;
}

}  // namespace host_sim
