// What an anti-alias filter, or thinning out, makes of a jump of an acceleration: it is rounded. Dry friction jumps at every
// reversal; a simulation that jumps at once sees too little of it.
#pragma once
#include <Eigen/Core>

namespace diagnosis::runs {

// Rounds over `samples`, an acceleration's reading. A slow motion stays as it is: of a Gaussian's response g it has
// 1 - (1 - g)^3, which is level where g is near one. Its two ends stay as they are.
class Rounding {
 public:
  explicit Rounding(double samples);
  bool any() const { return kernel_.size() > 1; }
  Eigen::VectorXd of(const Eigen::Ref<const Eigen::VectorXd>& y) const;

 private:
  Eigen::VectorXd kernel_;
};

}  // namespace diagnosis::runs
