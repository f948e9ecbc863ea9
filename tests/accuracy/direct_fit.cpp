#include "tests/accuracy/direct_fit.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace accuracy {
namespace {

using host_sim::Quantity;
using host_sim::Record;

struct Unknown {
  size_t link;
  bool coulomb;
};

std::vector<Unknown> list_unknowns(const rig_file::RigModel& rig) {
  std::vector<Unknown> unknowns;
  for (size_t l = 0; l < rig.links.size(); ++l) {
    if (rig.links[l].viscous_N_s_m.estimate) unknowns.push_back({l, false});
    if (rig.links[l].coulomb_N.estimate) unknowns.push_back({l, true});
  }
  return unknowns;
}

// A channel's values, or zeros: ground, or a DOF without force.
std::vector<double> values(const Record& record, Quantity quantity, int dof) {
  const host_sim::Channel* channel = dof == rig_file::kGround ? nullptr : record.find(quantity, dof);
  return channel == nullptr ? std::vector<double>(record.samples(), 0.0) : channel->values;
}

struct Motion {
  std::vector<std::vector<double>> elongation, rate;  // per link
};

Motion link_motion(const rig_file::RigModel& rig, const Record& record) {
  Motion motion;
  const auto difference = [&](Quantity quantity, const rig_file::Link& link) {
    std::vector<double> a = values(record, quantity, link.a);
    const std::vector<double> b = values(record, quantity, link.b);
    for (size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
    return a;
  };
  for (const rig_file::Link& link : rig.links) {
    motion.elongation.push_back(difference(Quantity::kDisplacement, link));
    motion.rate.push_back(difference(Quantity::kVelocity, link));
  }
  return motion;
}

// +1 where the link's force acts on the DOF with its own sign in the equation of motion, -1 on its other end.
double side(const rig_file::Link& link, int dof) { return link.a == dof ? 1.0 : link.b == dof ? -1.0 : 0.0; }

}  // namespace

std::vector<double> direct_fit(const rig_file::RigModel& rig, const std::vector<Record>& records) {
  const std::vector<Unknown> unknowns = list_unknowns(rig);
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size), row(size);
  for (const Record& record : records) {
    const Motion motion = link_motion(rig, record);
    for (size_t i = 0; i < rig.dofs.size(); ++i) {
      const int dof = static_cast<int>(i + 1);
      const std::vector<double> force = values(record, Quantity::kForce, dof);
      const std::vector<double> acceleration = values(record, Quantity::kAcceleration, dof);
      for (size_t k = 0; k < record.samples(); ++k) {
        double rest = force[k] - rig.dofs[i].mass_kg.value * acceleration[k];
        for (size_t l = 0; l < rig.links.size(); ++l)
          rest -= side(rig.links[l], dof) * rig.links[l].stiffness_N_m.value * motion.elongation[l][k];
        for (size_t u = 0; u < unknowns.size(); ++u) {
          const double rate = motion.rate[unknowns[u].link][k];
          const double unit_force = unknowns[u].coulomb ? static_cast<double>((rate > 0.0) - (rate < 0.0)) : rate;
          row(static_cast<Eigen::Index>(u)) = side(rig.links[unknowns[u].link], dof) * unit_force;
        }
        normal.noalias() += row * row.transpose();
        right += rest * row;
      }
    }
  }
  const Eigen::VectorXd solution = normal.ldlt().solve(right);
  return {solution.data(), solution.data() + solution.size()};
}

}  // namespace accuracy
