// One model against the windows of its records: residuals, and how they answer to states and parameters.
#pragma once
#include <memory>
#include <vector>

#include "../simulate/simulator.hpp"

namespace diagnosis::runs {

// A stretch of a record that is simulated by itself, from a free state.
struct Window {
  size_t record = 0;
  Index from = 0, length = 0;
  Vec state;            // of the simulator, then the offsets of channels that have one; empty: to be guessed
  bool unseen = false;  // not for the fit
};

// One window's run. Rows: channel by channel, sample by sample.
struct WindowRun {
  Vec residual;            // measured less simulated
  Sensitivity slopes;      // of the simulated: rows x (states, offsets, parameters)
  Mat x, v, a;             // nodes x samples
  Vec end;                 // state one sample after the last, where the record goes on and no slopes are asked for
  std::vector<Mat> step;   // per sample: states x states, where kept
  std::vector<Mat> acc;    // per sample: nodes x states
  std::vector<Mat> yield;  // per sample: nodes x nodes
  Index nuisances = 0;     // states and offsets, the first columns of slopes
};

constexpr int kForceTrace = 3;  // quantity of a trace that is a force: what is compared where nothing has mass

class Evaluator {
 public:
  Evaluator(const System& system, const Model& model, const std::vector<Prepared>& records);
  bool sound() const { return sound_; }
  bool massless() const { return massless_; }
  Index parameters() const { return parameters_; }
  const std::vector<MotionTrace>& traces(size_t record) const {
    return massless_ ? force_traces_[record] : records_[record].traces;
  }
  // The guess for a window, keeping what it has where the model has changed since.
  Vec carried_state(const Window& w) const;
  // False where the run does not stay finite. keep: transitions too, for candidates. Runs of different lanes (in_parallel.hpp) may
  // be under way at the same time; the model they are of must be what it was.
  bool run(const Window& w, bool slopes, bool keep, WindowRun& out, size_t lane = 0);
  // Channels whose zero is free in every window: accelerations, displacements that nothing drives (where a sensor's zero and a
  // constant force are the same), and velocities of what nothing drives and springs hold in its place: a gyroscope's.
  bool has_offset(const MotionTrace& t) const { return t.quantity == 2 || (!driven_ && (t.quantity == 0 || held_)); }
  // Without masses, of a channel's samples in a window: 1, or 0 where the motion turns round: the residual is nought there.
  Vec counted_of(const Window& w, Index channel) const;
  // Columns of candidates over a window, likewise.
  void leave_out_reversals(const Window& w, Mat& columns) const;
  void moved(const Window& w, const Vec& change, Vec& state) const;  // state after a change of the nuisances

 private:
  void take_forces(const Simulator& s, const Prepared& record);
  bool simulate(Simulator& s, const Window& w, bool slopes, bool keep, WindowRun& out) const;
  Simulator& simulator(size_t record, size_t lane);
  void from_motion(const Window& w, bool slopes, WindowRun& out) const;
  void round_jumps(const Window& w, bool slopes, Mat& h, WindowRun& out) const;
  void faults(const Window& w, bool slopes, Mat& h, WindowRun& out) const;
  Index parameter_of(size_t term) const;  // the first that a term has; -1: none
  const System& system_;
  const Model& model_;
  const std::vector<Prepared>& records_;
  std::vector<std::vector<MotionTrace>> force_traces_;         // per record, without masses: what is compared
  using Simulators = std::vector<std::unique_ptr<Simulator>>;  // per record
  Simulators simulators_;                                      // of the first lane
  std::vector<Simulators> of_lanes_;                           // of the others, made when first asked for
  struct MotionForces {
    Mat force;
    std::vector<Mat> slopes;
    Mat counted;  // dofs x samples: 1; 0 where the motion turns round
  };
  std::vector<MotionForces> forces_;  // per record, without masses
  bool sound_ = true, massless_ = false, driven_ = false;
  const bool held_;
  Index parameters_ = 0, dofs_ = 0;
};

}  // namespace diagnosis::runs
