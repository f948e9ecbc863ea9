// What runs miss of a stretch of measured motion.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

struct Sizes {
  double x_m = 0.0, v_m_s = 0.0;
};

class Misfit {
 public:
  // From a sample on; the stretch is as long as every channel needs for some periods, and at most `most` samples.
  Misfit(const Record& record, size_t from, size_t most);
  size_t samples() const { return count_; }
  // Residuals of every channel that moves, in shares of its rms about its mean; the squares of a channel's add up to 1 where the run
  // shows nothing of it. An accelerometer's zero is free.
  Eigen::VectorXd of(const Record& run) const;
  // About how far and how fast the channels show a DOF to move; nothing where it has none.
  Sizes sizes(int dof) const;
  // How far a channel's single samples are off: what their third differences are of white noise. Not a number where it is not there.
  double noise(Quantity quantity, int dof) const;

 private:
  struct Reading {
    const Channel* channel;
    double rms;
  };
  size_t from_, count_ = 0;
  double radian_s_;  // of a motion that takes the stretch for its periods: what a rate is times to be a displacement
  std::vector<Reading> readings_;
};

}  // namespace host_sim
