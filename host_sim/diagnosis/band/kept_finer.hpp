// Drives between their samples, kept: every model that is tried on a record asks for the same.
#pragma once
#include <Eigen/Core>
#include <list>
#include <memory>
#include <mutex>

namespace diagnosis::runs {

class KeptFiner {
 public:
  // finer() of a series that reads late by that many samples. Threads may ask at the same time.
  std::shared_ptr<const Eigen::VectorXd> of(const Eigen::VectorXd& y, double late, Eigen::Index per);

 private:
  struct Made {
    Eigen::VectorXd y;
    double late;
    Eigen::Index per;
    std::shared_ptr<const Eigen::VectorXd> finer;
  };
  std::mutex mutex_;
  std::list<Made> made_;  // the last asked for first
};

}  // namespace diagnosis::runs
