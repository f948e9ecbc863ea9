#include "host_sim/plant/motion/fitted_start.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/plant/motion/movable_start.hpp"

namespace host_sim {
namespace {

constexpr double kMetAlready = 1e-8;  // mean square, in shares of the channels': samples that no noise is on
constexpr double kNudge = 0.01;       // of a state's size, to see what it does to the run
constexpr double kWeakest = 1e-6;     // of the strongest state's squares: what a state that does nothing is held by
constexpr double kChance = 4.0;       // times what as many numbers take out of white residuals
constexpr int kRounds = 3, kHalvings = 3;
constexpr double kWorthMore = 0.9;  // of what is left: what a round has to bring to be followed by another

// What the residuals do when a state is moved by its size, a column per state.
std::optional<Eigen::MatrixXd> slopes(const MovableStart& start) {
  const Eigen::Index n = static_cast<Eigen::Index>(start.states());
  Eigen::MatrixXd out(start.missed().size(), n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto nudged = start.missed_from(kNudge * Eigen::VectorXd::Unit(n, i));
    if (!nudged) return std::nullopt;
    out.col(i) = (*nudged - start.missed()) / kNudge;
  }
  return out;
}

// How far the states are to be moved: Gauss-Newton with the slopes at the measured state, which every measured state is held at as
// firmly as its noise says beside that of the residuals. So the run of a wrong rig begins where the motion does.
class Move {
 public:
  Move(const MovableStart& start, const Eigen::MatrixXd& slope)
      : start_(start), slope_(slope), missed_(start.missed()) {
    at_ = Eigen::VectorXd::Zero(slope.cols());
    normal_ = slope.transpose() * slope;
    normal_.diagonal().array() += std::max(kWeakest * normal_.diagonal().maxCoeff(), 1e-300);
  }
  Eigen::VectorXd best() {
    for (int round = 0; round < kRounds && improved(); ++round) continue;
    const double chance = kChance * static_cast<double>(start_.states()) / static_cast<double>(missed_.size());
    if (!(missed_.squaredNorm() < (1.0 - chance) * start_.missed().squaredNorm())) at_.setZero();
    return at_;
  }

 private:
  // One step; false where there is no more to be had.
  bool improved() {
    const double variance = missed_.squaredNorm() / static_cast<double>(missed_.size());
    const Eigen::VectorXd hold = variance * start_.firmness();
    const auto cost = [&](const Eigen::VectorXd& missed, const Eigen::VectorXd& at) {
      return missed.squaredNorm() + at.dot(hold.cwiseProduct(at));
    };
    const Eigen::LLT<Eigen::MatrixXd> factors(normal_ + Eigen::MatrixXd(hold.asDiagonal()));
    Eigen::VectorXd step = -factors.solve(slope_.transpose() * missed_ + hold.cwiseProduct(at_));
    const double before = cost(missed_, at_);
    for (int halving = 0; halving <= kHalvings; ++halving, step *= 0.5) {
      const auto there = start_.missed_from(at_ + step);
      if (!there || cost(*there, at_ + step) >= before) continue;
      at_ += step, missed_ = *there;
      break;
    }
    return cost(missed_, at_) < kWorthMore * before;
  }

  const MovableStart& start_;
  const Eigen::MatrixXd& slope_;
  Eigen::VectorXd missed_, at_;
  Eigen::MatrixXd normal_;
};

}  // namespace

InitialState fitted_start(const FreeRun& run, const rig_file::RigModel& rig, const Record& record, size_t sample,
                          size_t count) {
  const InitialState measured = measured_state(rig, record, sample);
  // All the runs together take about as long as twice the one from the start.
  const size_t runs = 2 * rig.dofs.size() + 4;
  const Misfit misfit(record, sample, std::min(count, std::max<size_t>(256, 2 * count / runs)));
  if (misfit.samples() == 0) return measured;
  const MovableStart start(run, misfit, sample, measured);
  if (!start.movable() || start.missed().squaredNorm() <= kMetAlready) return measured;
  const auto slope = slopes(start);
  return slope ? start.moved(Move(start, *slope).best()) : measured;
}

Record run_beside(const rig_file::RigModel& rig, const Record& record, const std::vector<size_t>& starts) {
  const FreeRun run(rig, record);
  Record whole;
  for (size_t i = 0; i < starts.size(); ++i) {
    const size_t count = (i + 1 < starts.size() ? starts[i + 1] : record.samples()) - starts[i];
    Record part = run.samples(starts[i], fitted_start(run, rig, record, starts[i], count), count);
    if (i == 0) {
      whole = std::move(part);
      continue;
    }
    for (size_t c = 0; c < whole.channels.size(); ++c)
      whole.channels[c].values.insert(whole.channels[c].values.end(), part.channels[c].values.begin(),
                                      part.channels[c].values.end());
  }
  return whole;
}

}  // namespace host_sim
