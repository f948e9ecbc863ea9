#include "score.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/drive_noise.hpp"
#include "error_sums.hpp"
#include "unseen_windows.hpp"

namespace diagnosis::runs {
namespace {

// Variance of a channel's noise: what a model leaves of it above the motion's band, but no more than there is of
// white noise in the channel itself. A bad model leaves more.
double noise_in(const Vec& y, double left) {
  return y.size() < 4 ? left : std::min(left, white_noise_sum(y) / static_cast<double>(y.size() - 3));
}

const Mat& of_quantity(const WindowRun& run, int quantity) {
  return quantity == 0 ? run.x : quantity == 1 ? run.v : run.a;
}

// What is measured of a DOF: no displacement is judged that had to be integrated.
const MotionTrace& judged_trace(const Prepared& p, int dof) {
  for (const int quantity : {0, 1})
    if (const MotionTrace* trace = trace_of(p, dof, quantity)) return *trace;
  return *trace_of(p, dof, 2);
}

// The zero of an accelerometer is free (it reads a part of gravity), and that of a gyroscope.
void without_mean(Vec& y) { y.array() -= y.mean(); }

double mean_motion_square(const Vec& y, const Span& moving) {
  return std::pow(rms_about_mean(y.segment(moving.from, moving.to - moving.from)), 2);
}

class FreeRuns {
 public:
  FreeRuns(const Task& task, const State& state, const Vec* noise)
      : task_(task),
        state_(state),
        noise_(noise && noise->size() ? noise : nullptr),
        evaluator_(task.system, state.model, task.records),
        noisy_drives_(noise && !evaluator_.massless() && drives_have_noise(task.records)),
        finite_(evaluator_.sound()),
        dofs_(task.system.dofs()) {}

  // Record after record: each has its own noise of the drives.
  void over(size_t record) {
    if (!finite_) return;
    const Unseen unseen = unseen_windows(task_, state_, record, evaluator_.massless());
    std::vector<Prepared> noisy_record;
    if (noisy_drives_) noisy_record.push_back(drive_noise_.added_to(task_.records[record]));
    Evaluator noisy(task_.system, state_.model, noisy_record);
    WindowRun run, other;
    for (Window w : unseen.windows) {
      w.state = evaluator_.carried_state(w);
      finite_ = evaluator_.run(w, false, false, run);
      if (!finite_) return;
      Window again = w;
      again.record = 0;
      const bool compared = noisy_drives_ && noisy.run(again, false, false, other);
      for (size_t d = 0; d < dofs_.size(); ++d)
        if (evaluator_.massless())
          add_forces(static_cast<int>(d), w, run);
        else
          add_motion(static_cast<int>(d), w, unseen, run, compared ? &other : nullptr);
    }
    for (DofErrors& of : dofs_)
      for (ErrorSums* sums : {&of.x, &of.v, &of.a, &of.driven}) sums->end_record();
  }

  Score score() {
    if (evaluator_.massless()) std::for_each(dofs_.begin(), dofs_.end(), count_steady_force);
    return score_of(dofs_, finite_);
  }

 private:
  double noise_of(const MotionTrace& trace, Index channel) const {
    return noise_ ? noise_in(trace.y, (*noise_)[channel]) : 0;
  }

  void add_forces(int dof, const Window& w, const WindowRun& run) {
    DofErrors& of = dofs_[static_cast<size_t>(dof)];
    const auto& traces = evaluator_.traces(w.record);
    for (size_t c = 0; c < traces.size(); ++c) {
      if (traces[c].dof != dof) continue;
      const Index channel = static_cast<Index>(c);
      const Vec y = traces[c].y.segment(w.from, w.length);
      of.x.add(y - run.residual.segment(channel * w.length, w.length), y, evaluator_.counted_of(w, channel));
      of.force += y.cwiseAbs2().dot(evaluator_.counted_of(w, channel));
      of.v = of.a = of.x;
      of.noise = noise_of(traces[c], channel);
    }
  }

  // other: the run under another noise of the drives; nullptr: there is none.
  void add_motion(int dof, const Window& w, const Unseen& unseen, const WindowRun& run, const WindowRun* other) {
    DofErrors& of = dofs_[static_cast<size_t>(dof)];
    const Prepared& p = task_.records[w.record];
    const Guess& g = p.guess[static_cast<size_t>(dof)];
    const MotionTrace& trace = judged_trace(p, dof);
    const Index channel = &trace - p.traces.data();
    of.steps = trace.rounding_variance();
    of.noise = std::max(of.steps, noise_of(trace, channel));
    if (other) of.driven.add(of_quantity(*other, trace.quantity).row(dof), of_quantity(run, trace.quantity).row(dof));
    // as the channel reads it: with its gain, delay and hum
    Vec reading = trace.y.segment(w.from, w.length);
    Vec alike = reading - run.residual.segment(channel * w.length, w.length);
    Vec acceleration = g.a.segment(w.from, w.length), simulated_a = run.a.row(dof);
    if (trace.quantity > 0 && evaluator_.has_offset(trace)) without_mean(alike), without_mean(reading);
    if (trace_of(p, dof, 2)) without_mean(acceleration), without_mean(simulated_a);
    of.x.add(alike, reading);
    of.v.add(run.v.row(dof), g.v.segment(w.from, w.length));
    of.a.add(simulated_a, acceleration);
    const double samples = static_cast<double>(w.length);
    if (trace.travels)
      of.x.motion += motion_square(p, trace, w.from, w.length);
    else if (unseen.spread)
      of.x.motion += samples * mean_motion_square(trace.y, unseen.moving);
    if (!unseen.spread) return;
    of.v.motion += samples * mean_motion_square(g.v, unseen.moving);
    of.a.motion += samples * mean_motion_square(g.a, unseen.moving);
  }

  const Task& task_;
  const State& state_;
  const Vec* const noise_;
  Evaluator evaluator_;
  const bool noisy_drives_;
  bool finite_;
  DriveNoise drive_noise_;
  std::vector<DofErrors> dofs_;
};

}  // namespace

Score score_unseen(const Task& task, const State& state, const Vec* noise) {
  const bool apart = task.training < task.records.size();
  FreeRuns runs(task, state, noise);
  for (size_t r = apart ? task.training : 0; r < task.records.size(); ++r) runs.over(r);
  return runs.score();
}

Score score_record(const Task& task, const State& state, size_t record, const Vec& noise) {
  FreeRuns runs(task, state, &noise);
  runs.over(record);
  return runs.score();
}

}  // namespace diagnosis::runs
