// A measured state that is moved a little: what the run from there misses.
#pragma once
#include <optional>

#include "host_sim/plant/motion/free_run.hpp"
#include "host_sim/plant/motion/misfit.hpp"

namespace host_sim {

// Moves are one vector: displacements, then velocities, each in units of its size in the run. Run and misfit must outlive it.
class MovableStart {
 public:
  // Throws PlantError where the rig cannot be run from the measured state.
  MovableStart(const FreeRun& run, const Misfit& misfit, size_t sample, InitialState measured);
  size_t states() const { return 2 * measured_.x_m.size(); }
  bool movable() const { return missed_.size() > 0 && size_.minCoeff() > 0.0; }
  const Eigen::VectorXd& missed() const { return missed_; }  // from the measured state
  // Per state: its size over its noise, squared; 0 where it is not measured.
  const Eigen::VectorXd& firmness() const { return firmness_; }
  InitialState moved(const Eigen::VectorXd& by) const;
  // Nothing where the rig cannot be run from there.
  std::optional<Eigen::VectorXd> missed_from(const Eigen::VectorXd& by) const;

 private:
  void take_sizes(const Record& first);
  void take_firmness(double period_s);
  void hold(Eigen::Index state, double noise);

  const FreeRun& run_;
  const Misfit& misfit_;
  size_t sample_;
  InitialState measured_;
  Eigen::VectorXd missed_, size_, firmness_;
};

}  // namespace host_sim
