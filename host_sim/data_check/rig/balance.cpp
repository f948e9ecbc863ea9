#include "host_sim/data_check/rig/balance.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/bell.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kTellsApart = 0.1;  // smallest singular value but one, of columns of unit length

bool is_moving(const Channel& channel) {
  return std::any_of(channel.values.begin(), channel.values.end(),
                     [&](double value) { return value != channel.values.front(); });
}

Eigen::VectorXd without_mean(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> of(values.data(), static_cast<Eigen::Index>(values.size()));
  return of.array() - (values.empty() ? 0.0 : of.mean());
}

// Takes what the free columns explain off the known ones.
void project(const std::vector<Eigen::VectorXd>& known, const std::vector<Eigen::VectorXd>& free, Equation& equation) {
  if (known.size() < 2 || known.front().size() < 4 * static_cast<Eigen::Index>(free.size() + known.size())) return;
  const Eigen::Index rows = known.front().size();
  Eigen::MatrixXd nuisance(rows, static_cast<Eigen::Index>(free.size()));
  for (size_t i = 0; i < free.size(); ++i)
    nuisance.col(static_cast<Eigen::Index>(i)) = free[i] / std::max(free[i].norm(), 1e-300);
  Eigen::MatrixXd columns(rows, static_cast<Eigen::Index>(known.size()));
  for (size_t i = 0; i < known.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = known[i];
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(nuisance);
  columns -= nuisance * solver.solve(columns);
  equation.products = columns.transpose() * columns;
  for (size_t i = 0; i < known.size(); ++i)
    if (equation.channel[i] == equation.reference_channel)
      equation.reference = std::max(equation.reference, equation.products.diagonal()[static_cast<Eigen::Index>(i)]);
}

// One relation among the columns is the equation itself; a second one means that they cannot be told apart. The columns'
// singular values are the roots of their products' eigenvalues.
bool tells_apart(const Equation& equation) {
  if (!(equation.reference > 0.0) || !(equation.products.diagonal().minCoeff() > 0.0)) return false;
  const Eigen::VectorXd scale = equation.products.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * equation.products * scale.asDiagonal();
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unit, Eigen::EigenvaluesOnly).eigenvalues();
  return squares[1] > kTellsApart * kTellsApart;  // the smallest is the first
}

}  // namespace

Balance::Balance(const Record& record, const rig_file::RigModel& model) : record_(record), model_(model) {
  for (int dof = 1; dof <= static_cast<int>(model.dofs.size()); ++dof) take_motion(dof);
  for (const rig_file::Link& link : model.links)
    if (link.b == rig_file::kBase && motion_.count(rig_file::kBase) == 0) take_motion(rig_file::kBase);
  for (const auto& [dof, used] : motion_) differentiate_ = std::max(differentiate_, used.order);
  for (const Channel& channel : record.channels)
    if (channel.quantity == Quantity::kForce && is_moving(channel)) {
      force_[channel.dof] = channels_.size();
      channels_.push_back(&channel);
    }
}

std::vector<Equation> Balance::equations(size_t h) {
  std::vector<Equation> result;
  for (int dof = 1; dof <= static_cast<int>(model_.dofs.size()); ++dof) {
    Equation equation = equation_of(dof, h);
    if (equation.products.cols() >= 2 && tells_apart(equation)) result.push_back(std::move(equation));
  }
  return result;
}

void Balance::take_motion(int dof) {
  for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
    if (const Channel* channel = record_.find(quantity, dof); channel != nullptr && is_moving(*channel)) {
      motion_[dof] = {channel, static_cast<int>(quantity) - static_cast<int>(Quantity::kDisplacement)};
      place_[dof] = channels_.size();
      channels_.push_back(channel);
      return;
    }
}

const std::vector<double>& Balance::thinned(const Channel& channel, int derivative, size_t h) {
  Thinned& thin = thinned_[{&channel, derivative}];
  if (thin.h == h) return thin.values;
  if (2 * thin.h == h) {
    thin.values = twice_as_wide(thin.values);
  } else {
    const std::vector<double> all = bell(channel.values, derivative, h, record_.sample_period_s);
    thin.values.resize(all.size() / h);
    for (size_t i = 0; i < thin.values.size(); ++i) thin.values[i] = all[i * h];
  }
  thin.h = h;
  return thin.values;
}

Eigen::VectorXd Balance::column(int dof, int order, size_t h) {
  const Used& used = motion_.at(dof);
  return without_mean(thinned(*used.channel, differentiate_ + order - used.order, h));
}

Equation Balance::equation_of(int dof, size_t h) {
  Equation equation;
  const rig_file::Dof& body = model_.dofs[static_cast<size_t>(dof - 1)];
  if (motion_.count(dof) == 0 || !body.effects.empty()) return equation;
  std::vector<Eigen::VectorXd> known, free = {column(dof, 1, h)};
  const auto add = [&](size_t channel, Eigen::VectorXd values) {
    equation.channel.push_back(channel);
    known.push_back(std::move(values));
  };
  if (body.mass_kg.estimate) {
    free.push_back(column(dof, 2, h));
  } else if (body.mass_kg.value > 0.0) {
    add(place_.at(dof), body.mass_kg.value * column(dof, 2, h));
  }
  std::map<int, double> spring;  // by DOF: what its displacement is multiplied with
  for (const rig_file::Link& link : model_.links) {
    if (link.a != dof && link.b != dof) continue;
    const int other = link.a == dof ? link.b : link.a;
    if (!link.effects.empty() || link.gravity_torque_N_m.estimate || link.gravity_torque_N_m.value != 0.0 ||
        (other != rig_file::kGround && motion_.count(other) == 0))
      return Equation();
    for (const int end : {dof, other}) {
      if (end == rig_file::kGround) continue;
      if (end != dof) free.push_back(column(end, 1, h));
      if (link.stiffness_N_m.estimate) {
        free.push_back(column(end, 0, h));
      } else if (link.stiffness_N_m.value > 0.0) {
        spring[end] += (end == dof ? 1.0 : -1.0) * link.stiffness_N_m.value;
      }
    }
  }
  for (const auto& [end, stiffness] : spring) add(place_.at(end), stiffness * column(end, 0, h));
  if (force_.count(dof) > 0) {
    equation.reference_channel = force_.at(dof);
    const Channel& force = *channels_[force_.at(dof)];
    add(force_.at(dof), -without_mean(thinned(force, differentiate_, h)));
  } else {
    equation.reference_channel = place_.at(dof);
  }
  project(known, free, equation);
  return equation;
}

// The share of the reference that is not explained when each channel's values are multiplied so: the worst equation's.
double unexplained(const std::vector<Equation>& equations, const std::vector<double>& times) {
  double worst = 0.0;
  for (const Equation& equation : equations) {
    Eigen::VectorXd weights(equation.products.cols());
    for (Eigen::Index i = 0; i < weights.size(); ++i) weights[i] = times[equation.channel[static_cast<size_t>(i)]];
    const double reference = equation.reference * std::pow(times[equation.reference_channel], 2);
    worst = std::max(worst, std::max(0.0, weights.dot(equation.products * weights)) / reference);
  }
  return worst;
}

}  // namespace host_sim::data_check
