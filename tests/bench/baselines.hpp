// What a user would write instead of the core, in double with Eigen; one step() per sample of all DOFs.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "tests/bench/bench_rig.hpp"

namespace bench {

// The sampled equations of motion: for every DOF a row over the unknowns (viscous of links 0 .. n, Coulomb of link n).
class EquationRows {
 public:
  explicit EquationRows(int dofs);
  int unknowns() const { return dofs_ + 2; }
  void fill(const Sample& sample);
  Eigen::MatrixXd row;  // dofs x unknowns
  Eigen::VectorXd rhs;  // dofs

 protected:
  int dofs_;
};

// Recursive least squares with forgetting, one update per DOF and sample, matrices of dynamic size.
class RecursiveLeastSquares {
 public:
  explicit RecursiveLeastSquares(int dofs);
  void step(const Sample& sample);
  Eigen::VectorXd parameters;

 private:
  EquationRows rows_;
  Eigen::MatrixXd covariance_;
};

// Normal equations of the sampled equations of motion.
class BatchLeastSquares {
 public:
  explicit BatchLeastSquares(int dofs);
  void step(const Sample& sample);
  Eigen::MatrixXd normal;
  Eigen::VectorXd right;

 private:
  EquationRows rows_;
};

// The paper's energy sums, Eq. 10 to 12a, in plain loops over links.
class EnergySumsInDouble {
 public:
  explicit EnergySumsInDouble(int dofs);
  void step(const Sample& sample);
  std::vector<double> viscous_a, viscous_b, coulomb, rhs;

 private:
  int dofs_;
};

}  // namespace bench
