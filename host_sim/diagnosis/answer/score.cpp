// Free runs on data that the fit has not seen.
#include <algorithm>
#include <cmath>

#include "../motion/drive_noise.hpp"
#include "answer.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMostPercent = 1000;  // more says no more
// Where no spring holds a DOF in its place the run starts anew that often; where it runs on, after a period of what is off its line.
constexpr double kRestart_s = 1;

struct Sums {
  double error = 0, square = 0, sum = 0, count = 0;
  double motion = 0;  // sum of squares that stands for that about the mean; 0: none does
  void add(const Vec& simulated, const Vec& measured) {
    error += (simulated - measured).squaredNorm(), square += measured.squaredNorm(), sum += measured.sum();
    count += static_cast<double>(measured.size());
  }
  double mean_error() const { return count > 0 ? error / count : 0; }
  double variance() const { return motion > 0 ? motion / count : square / count - std::pow(sum / count, 2); }
  double ratio() const { return variance() > 0 ? error / count / variance() : 0; }  // mean square over variance
  // The same without what the channel's steps make of both.
  double ratio_beyond(double of_steps) const {
    const double moves = variance() - of_steps;
    return moves > 0 ? std::max(0.0, error / count - of_steps) / moves : ratio();
  }
  bool shows(double noise) const { return variance() > kShown * noise; }
};

// Variance of a channel's noise: what a model leaves of it above the motion's band, but no more than there is of
// white noise in the channel itself. A bad model leaves more.
double noise_in(const Vec& y, double left) {
  return y.size() < 4 ? left : std::min(left, white_noise_sum(y) / static_cast<double>(y.size() - 3));
}

const Mat& of_quantity(const WindowRun& run, int quantity) {
  return quantity == 0 ? run.x : quantity == 1 ? run.v : run.a;
}

// Where the record's end moves too little to be judged by: the windows that were kept apart instead of it.
std::vector<Window> unseen_of(const State& state, size_t record, const std::vector<Window>& end) {
  std::vector<Window> list;
  for (const Window& w : state.unseen)
    if (w.record == record) list.push_back(w);
  return list.empty() ? end : list;
}

// The zero of an accelerometer is free (it reads a part of gravity), and that of a gyroscope.
void without_mean(Vec& y) { y.array() -= y.mean(); }

double capped(double percent) { return std::isfinite(percent) ? std::min(percent, kMostPercent) : kMostPercent; }

}  // namespace

Score score_unseen(const Task& task, const State& state, const Vec* noise) {
  const size_t n = task.system.dofs();
  Evaluator evaluator(task.system, state.model, task.records);
  std::vector<Sums> x(n), v(n), a(n), driven(n);  // driven: what noise of the drives makes of x
  DriveNoise drive_noise;
  const bool noisy_drives = noise && !evaluator.massless() && drives_have_noise(task.records);
  std::vector<double> noise_of(n, 0.0), steps_of(n, 0.0);  // of what stands in x: of all its noise, of its steps
  bool finite = evaluator.sound();
  const bool held = vocabulary::held_in_place(task.system.rig);
  const bool apart = task.training < task.records.size(), pushed = forced(task.records) && !evaluator.massless();
  WindowRun run;
  for (size_t r = apart ? task.training : 0; r < task.records.size() && finite; ++r) {
    const Prepared& p = task.records[r];
    const Span span = moving_span(p, pushed);
    const std::vector<Prepared> noisy_record(noisy_drives ? 1 : 0, noisy_drives ? drive_noise.added_to(p) : Prepared{});
    Evaluator noisy(task.system, state.model, noisy_record);
    WindowRun other;
    const Index all = span.to;
    const Index first = span.from + (apart ? 0 : static_cast<Index>(0.7 * static_cast<double>(all - span.from)));
    const bool runs_on = std::any_of(p.traces.begin(), p.traces.end(), [](const MotionTrace& t) { return t.travels; });
    const double part_s = runs_on ? std::max(kRestart_s, p.period_s) : kRestart_s;
    const Index part =
        held || evaluator.massless() ? all - first : std::max<Index>(12, static_cast<Index>(part_s / p.step_s));
    std::vector<Window> runs;
    for (Index from = first; from + 12 <= all; from += part) {
      Window w;
      w.record = r, w.from = from, w.length = std::min(part, all - from);
      // the state at its start: as the first window of a short fit tells, where there is one
      for (const Window& u : state.unseen)
        if (u.record == r && u.from == from && u.state.size()) w.state = u.state;
      runs.push_back(w);
    }
    // windows from all over the record are held against its motion: many of them are as steady as its end, and noise over noise says nothing
    const bool spread = !apart && ends_steadily(p, pushed, 0.3);
    if (spread) runs = unseen_of(state, r, runs);
    const auto motion_of_all = [&](const Vec& y) {
      return std::pow(rms_about_mean(y.segment(span.from, span.to - span.from)), 2);
    };
    for (Window w : runs) {
      if (!finite) break;
      w.state = evaluator.carried_state(w);
      if (!evaluator.run(w, false, false, run)) {
        finite = false;
        break;
      }
      Window again = w;
      again.record = 0;
      const bool compared = noisy_drives && noisy.run(again, false, false, other);
      for (size_t d = 0; d < n; ++d) {
        const Index i = static_cast<Index>(d);
        if (evaluator.massless()) {
          const auto& traces = evaluator.traces(r);
          for (size_t c = 0; c < traces.size(); ++c)
            if (traces[c].dof == static_cast<int>(d)) {
              const Vec y = traces[c].y.segment(w.from, w.length);
              x[d].add(y - run.residual.segment(static_cast<Index>(c) * w.length, w.length), y);
              v[d] = a[d] = x[d];
              if (noise && noise->size()) noise_of[d] = noise_in(traces[c].y, (*noise)[static_cast<Index>(c)]);
            }
          continue;
        }
        const Guess& g = p.guess[d];
        bool accelerometer = false;
        // what is measured of this DOF: no displacement is judged that had to be integrated
        const MotionTrace* measured = nullptr;
        for (const MotionTrace& t : p.traces) accelerometer |= t.dof == static_cast<int>(d) && t.quantity == 2;
        for (const MotionTrace& t : p.traces)
          if (t.dof == static_cast<int>(d) && (!measured || t.quantity < measured->quantity)) {
            measured = &t;
            noise_of[d] = steps_of[d] = t.rounding_variance();
            if (noise && noise->size())
              noise_of[d] = std::max(noise_of[d], noise_in(t.y, (*noise)[static_cast<Index>(&t - p.traces.data())]));
          }
        const Mat& simulated = of_quantity(run, measured->quantity);
        if (compared) driven[d].add(of_quantity(other, measured->quantity).row(i), simulated.row(i));
        // as the channel reads it: with its gain, delay and hum
        Vec reading = measured->y.segment(w.from, w.length);
        Vec alike = reading - run.residual.segment((measured - p.traces.data()) * w.length, w.length);
        Vec acceleration = g.a.segment(w.from, w.length), simulated_a = run.a.row(i);
        if (measured->quantity > 0 && evaluator.has_offset(*measured)) without_mean(alike), without_mean(reading);
        if (accelerometer) without_mean(acceleration), without_mean(simulated_a);
        x[d].add(alike, reading);
        const double samples = static_cast<double>(w.length);
        if (measured->travels)
          x[d].motion += motion_square(p, *measured, w.from, w.length);
        else if (spread)
          x[d].motion += samples * motion_of_all(measured->y);
        if (spread) v[d].motion += samples * motion_of_all(g.v), a[d].motion += samples * motion_of_all(g.a);
        v[d].add(run.v.row(i), g.v.segment(w.from, w.length));
        a[d].add(simulated_a, acceleration);
      }
    }
  }
  Score score;
  for (size_t d = 0; d < n; ++d) {
    const bool any = finite && x[d].count > 0;
    score.nrmse_percent.push_back(any ? capped(100 * std::sqrt(x[d].ratio())) : kMostPercent);
    score.velocity_percent.push_back(any ? capped(100 * std::sqrt(v[d].ratio())) : kMostPercent);
    score.mse_percent.push_back(any ? capped(100 * a[d].ratio()) : kMostPercent);
    const double beyond_steps = any ? capped(100 * std::sqrt(x[d].ratio_beyond(steps_of[d]))) : kMostPercent;
    const double worst = any && !x[d].shows(noise_of[d]) ? 0 : beyond_steps;
    score.by_steps_percent.push_back(any ? capped(100 * std::sqrt(steps_of[d] / std::max(x[d].variance(), 1e-300)))
                                         : 0);
    if (worst > score.worst_percent)
      score.worst_percent = worst,
      score.by_drives_percent = capped(100 * std::sqrt(driven[d].mean_error() / std::max(x[d].variance(), 1e-300)));
  }
  return score;
}

}  // namespace diagnosis::runs
