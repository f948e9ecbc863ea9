#include "leftovers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

#include "../fit/run_windows.hpp"
#include "../motion/drive_noise.hpp"

namespace diagnosis::runs {
namespace {

// What such noise makes of a window's run beside its free state.
Vec response(Evaluator& noisy, Window w, const WindowRun& run, size_t lane) {
  WindowRun other;
  w.record = 0;
  if (!noisy.run(w, false, false, other, lane)) return Vec::Zero(run.residual.size());
  Vec difference = other.residual - run.residual;
  const Mat states = run.slopes.leftCols(run.nuisances);
  if (states.cols() > 0) {
    const Vec scale = states.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    const Mat unit = states * scale.asDiagonal();
    Mat a = unit.transpose() * unit;
    a.diagonal().array() += 1e-9;
    difference -= unit * a.llt().solve(unit.transpose() * difference);
  }
  return difference;
}

// The records as noise of what drives them makes them, each by itself.
struct NoisyRecords {
  std::vector<std::vector<Prepared>> records;
  std::vector<std::unique_ptr<Evaluator>> evaluators;
  NoisyRecords(const System& system, const std::vector<Prepared>& clean, const State& state) : records(clean.size()) {
    DriveNoise noise;
    for (size_t r = 0; r < clean.size(); ++r) {
      records[r].push_back(noise.added_to(clean[r]));
      evaluators.push_back(std::make_unique<Evaluator>(system, state.model, records[r]));
    }
  }
};

bool any_steps(const std::vector<Prepared>& records, size_t channel) {
  return std::any_of(records.begin(), records.end(), [&](const Prepared& p) { return p.traces[channel].step > 0; });
}

// Of a slow motion it repeats with it. The grid is that of the readings.
void add_steps(const MotionTrace& trace, const Window& w, const double* residual, std::vector<double>& rows) {
  for (Index k = 0; k < w.length; ++k) {
    const double steps = trace.step > 0 ? (trace.y[w.from + k] - residual[k] - trace.y[0]) / trace.step : 0;
    rows.push_back(trace.step * (std::round(steps) - steps));
  }
}

}  // namespace

bool leave_over(const System& system, const std::vector<Prepared>& records, const State& state, Leftovers& out) {
  Evaluator evaluator(system, state.model, records);
  const size_t channels = evaluator.traces(0).size();
  out.massless = evaluator.massless();
  out.rows.resize(channels), out.pushed.resize(channels), out.steps.resize(channels);
  std::vector<Window> windows = state.seen;
  std::stable_sort(windows.begin(), windows.end(),
                   [](const Window& a, const Window& b) { return a.record < b.record; });
  const bool force_noise = drives_have_noise(records), pushes = force_noise && !out.massless;
  const NoisyRecords noisy(system, pushes ? records : std::vector<Prepared>{}, state);
  std::vector<Vec> rows(windows.size()), pushed(windows.size());
  const bool finite = run_windows(evaluator, windows, force_noise, [&](size_t i, const WindowRun& run, size_t lane) {
    rows[i] = run.residual;
    pushed[i] =
        pushes ? response(*noisy.evaluators[windows[i].record], windows[i], run, lane) : Vec::Zero(run.residual.size());
  });
  out.ends.assign(records.size(), 0);
  for (const Window& w : windows)
    for (size_t r = w.record; r < out.ends.size(); ++r) out.ends[r] += static_cast<size_t>(w.length);
  for (size_t i = 0; i < windows.size() && finite; ++i)
    for (size_t c = 0; c < channels; ++c) {
      const Index at = static_cast<Index>(c) * windows[i].length;
      out.rows[c].insert(out.rows[c].end(), rows[i].data() + at, rows[i].data() + at + windows[i].length);
      out.pushed[c].insert(out.pushed[c].end(), pushed[i].data() + at, pushed[i].data() + at + windows[i].length);
      if (!out.massless && any_steps(records, c))
        add_steps(records[windows[i].record].traces[c], windows[i], rows[i].data() + at, out.steps[c]);
    }
  return finite;
}

std::vector<std::vector<double>> Leftovers::rows_by_record(size_t channel) const {
  std::vector<std::vector<double>> list;
  const auto begin = rows[channel].begin();
  for (size_t r = 0, from = 0; r < ends.size(); from = ends[r++])
    list.emplace_back(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(ends[r]));
  return list;
}

Vec spectrum(const std::vector<double>& rows) {
  const size_t n = fast_length(rows.size());
  return Fourier(n).forward(Vec::Map(rows.data(), static_cast<Index>(n))).cwiseAbs2() / static_cast<double>(n);
}

}  // namespace diagnosis::runs
