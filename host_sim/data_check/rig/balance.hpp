// The equations of motion of a record's DOFs as columns whose sum vanishes where the channels and the rig file are right.
// Each is averaged with a bell and differentiated as often as its channels ask for (rig_balance.hpp).
#pragma once
#include <Eigen/Dense>
#include <map>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// The equation of one DOF: columns whose sum vanishes, one for each channel's known part, what friction and unknown
// coefficients explain taken off.
struct Equation {
  std::vector<size_t> channel;  // of each column: index into the balance's channels
  Eigen::MatrixXd products;     // of each column with each
  double reference = 0.0;       // squares of the force, or of the inertia where no force acts
  size_t reference_channel = 0;
};

// The lowest derivative that each DOF has, and the forces; channels that never change are left out.
class Balance {
 public:
  Balance(const Record& record, const rig_file::RigModel& model);
  // With a bell of six boxes of h samples. Equations without anything known, or whose columns cannot be told apart, are
  // left out. Asked for one h after twice the one before, it makes the wider bell from the narrower.
  std::vector<Equation> equations(size_t h);
  const std::vector<const Channel*>& channels() const { return channels_; }

 private:
  // A channel that the balance uses: the lowest derivative that the DOF has, or its force.
  struct Used {
    const Channel* channel = nullptr;
    int order = 0;  // 0 displacement, 1 velocity, 2 acceleration; of a force the equation's own
  };
  void take_motion(int dof);
  // A channel's derivative under the bell at every h-th sample.
  const std::vector<double>& thinned(const Channel& channel, int derivative, size_t h);
  // Without its mean: of the DOF's motion, differentiated as much further as all of the equation is.
  Eigen::VectorXd column(int dof, int order, size_t h);
  Equation equation_of(int dof, size_t h);

  const Record& record_;
  const rig_file::RigModel& model_;
  std::vector<const Channel*> channels_;
  std::map<int, Used> motion_;           // by DOF
  std::map<int, size_t> place_, force_;  // index into channels_, by DOF
  int differentiate_ = 0;
  struct Thinned {
    size_t h = 0;
    std::vector<double> values;
  };
  std::map<std::pair<const Channel*, int>, Thinned> thinned_;  // by channel and derivative
};

// The share of the reference that is not explained when each channel's values are multiplied so: the worst equation's.
// times: one for each of the balance's channels.
double unexplained(const std::vector<Equation>& equations, const std::vector<double>& times);

}  // namespace host_sim::data_check
