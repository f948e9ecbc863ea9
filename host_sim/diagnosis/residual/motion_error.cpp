// What a model misses of the motion over its windows.
#include "motion_error.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/median.hpp"

namespace diagnosis::runs {
namespace {

// What windows add up to: of a channel, or of the difference of two.
struct MotionSums {
  double error = 0, missed = 0, motion = 0, noise = 0, count = 0, third_differences = 0;
  void add(const Vec& y, const Vec& residual) { add((y.array() - y.mean()).square().sum(), residual); }
  void add(double motion_square, const Vec& residual) {
    error += residual.squaredNorm(), missed += residual.sum(), motion += motion_square;
    count += static_cast<double>(residual.size());
    noise += white_noise_sum(residual),
        third_differences += static_cast<double>(std::max<Index>(0, residual.size() - 3));
  }
  double about_mean() const { return error - missed * missed / std::max(1.0, count); }
  double noise_sum() const { return third_differences > 0 ? noise / third_differences * count : 0; }
};

// The two channels of one quantity at the ends of a link, -1 where there are none.
std::pair<int, int> channels_across(const rig_file::Link& l, const std::vector<MotionTrace>& traces, int quantity) {
  std::pair<int, int> found{-1, -1};
  for (size_t c = 0; c < traces.size(); ++c) {
    if (traces[c].quantity != quantity) continue;
    if (traces[c].dof + 1 == l.a) found.first = static_cast<int>(c);
    if (traces[c].dof + 1 == l.b) found.second = static_cast<int>(c);
  }
  return found.first < 0 || found.second < 0 ? std::make_pair(-1, -1) : found;
}

// of: what of the error's square counts.
template <typename Of>
double error_over_motion(const Task& task, const State& s, bool links_too, Of of) {
  if (!s.fit.ok) return 1e300;
  Evaluator e(task.system, s.model, task.records);
  const std::vector<MotionTrace>& traces = e.traces(0);
  std::vector<std::pair<int, int>> across;  // links between DOFs: masses that turn together hide what their shaft does
  for (size_t l = 0; l < task.system.known_links && !e.massless() && links_too; ++l)
    for (int q = 0; q < 3; ++q) {
      const auto ends = channels_across(task.system.links[l], traces, q);
      if (ends.first >= 0) across.push_back(ends);
    }
  std::vector<MotionSums> own(traces.size()), relative(across.size());
  WindowRun run;
  for (const Window& w : s.seen) {
    if (!e.run(w, false, false, run)) return 1e300;
    const auto y = [&](int c) { return e.traces(w.record)[static_cast<size_t>(c)].y.segment(w.from, w.length); };
    const auto r = [&](int c) { return run.residual.segment(c * w.length, w.length); };
    for (size_t c = 0; c < traces.size(); ++c)
      own[c].add(motion_square(task.records[w.record], e.traces(w.record)[c], w.from, w.length),
                 r(static_cast<int>(c)));
    for (size_t i = 0; i < across.size(); ++i)
      relative[i].add(Vec(y(across[i].first) - y(across[i].second)), r(across[i].first) - r(across[i].second));
  }
  double worst = 0;
  for (size_t c = 0; c < own.size(); ++c) {
    const double rounding = traces[c].rounding_variance() * own[c].count, motion = own[c].motion - rounding;
    if (motion < kShown * rounding) continue;  // a DOF that rests, but for a step of its encoder: nothing to follow
    worst = std::max(worst, std::sqrt(std::max(0.0, of(own[c]) - rounding) / std::max(1e-300, motion)));
  }
  for (const MotionSums& m : relative) {
    const double noise = m.noise_sum(), motion = m.motion - noise;
    if (motion > kShown * noise) worst = std::max(worst, std::sqrt(std::max(0.0, of(m) - noise) / motion));
  }
  return worst;
}

}  // namespace

double motion_error(const Task& task, const State& s, bool links_too) {
  return error_over_motion(task, s, links_too, [](const MotionSums& m) { return m.error; });
}

namespace {

// Of the stretches that the windows are made of, the error over the motion that half of them do not exceed, the worst channel's; huge
// where there is no fit.
double usual_error(const Task& task, const State& s) {
  if (!s.fit.ok) return 1e300;
  Evaluator e(task.system, s.model, task.records);
  const auto parts = static_cast<Index>(parts_for(s.seen.size()));
  std::vector<std::vector<double>> errors(e.traces(0).size());
  WindowRun run;
  for (const Window& w : s.seen) {
    if (!e.run(w, false, false, run)) return 1e300;
    for (size_t c = 0; c < errors.size(); ++c)
      for (Index part = 0; part < parts; ++part) {
        const Index from = part * w.length / parts, count = (part + 1) * w.length / parts - from;
        const double error = run.residual.segment(static_cast<Index>(c) * w.length + from, count).squaredNorm();
        const double motion =
            motion_square(task.records[w.record], e.traces(w.record)[c], w.from + from, std::max<Index>(count, 1));
        errors[c].push_back(std::sqrt(error / std::max(1e-300, motion)));
      }
  }
  double worst = 0;
  for (const std::vector<double>& list : errors) worst = std::max(worst, host_sim::median(list));
  return worst;
}

}  // namespace

bool follows(const Task& task, const State& s, bool links_too) {
  if (error_over_motion(task, s, links_too, [](const MotionSums& m) { return m.about_mean(); }) < kFollows) return true;
  return !forced(task.records) && usual_error(task, s) < kFollows;
}

}  // namespace diagnosis::runs
