// The smallest scatter that the energy rows, as the core counts them, allow: generalised least squares with rows free of
// noise (the mean of the draws) and the true
// covariance of the row noise, which the draws themselves give.
//
// Two bounds. "rows": from the energy equations alone. "identities": the kinematic discrepancies of all DOFs are
// observed too (they carry no parameter, but their noise is that of the rows), which is what the estimator uses.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "firmware/energy/batch_table.hpp"

namespace accuracy {

class Bound {
 public:
  // clean: the table without noise; truth: per unknown.
  Bound(const firmware::BatchTable& clean, const std::vector<double>& truth);
  void add(const firmware::BatchTable& noisy);  // one draw

  std::vector<double> rows() const { return deviations(false); }  // standard deviation per unknown
  std::vector<double> identities() const { return deviations(true); }

 private:
  // What is observed together: all DOFs of one periodic level, or of one batch of another level.
  struct Group {
    // Of the draws' columns, one row per DOF. Their mean is what the rows really hold: which samples count for friction
    // depends on the noise (links/clear_sign.hpp), and the instrument's own noise has the mean zero.
    Eigen::MatrixXd sum;
    std::vector<Eigen::VectorXd> draws;  // row residuals of all DOFs, then kinetic and elastic discrepancies
  };
  std::vector<double> deviations(bool with_identities) const;

  std::vector<double> truth_;
  std::vector<Group> groups_;
};

}  // namespace accuracy
