#include "mains_hum.hpp"

#include <Eigen/Dense>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "../residual/lines.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kGoodPart = 0.1;  // of what is left, mean square: less does not hide a cause
constexpr double kStep = 0.2;  // of a record's inverse duration: two frequencies further apart lose each other's phase
constexpr int kBits = 20;      // of the frequency, between two such steps

// What is left of one channel of one record.
struct Leftover {
  std::vector<double> time_s, value;
  double duration_s() const { return time_s.empty() ? 0 : time_s.back() - time_s.front(); }
};

Leftover leftover_of(Evaluator& evaluator, const Prepared& p, const State& state, size_t record, Index channel) {
  Leftover left;
  WindowRun run;
  for (const auto* windows : {&state.seen, &state.unseen})
    for (const Window& w : *windows) {
      if (w.record != record || w.state.size() == 0 || !evaluator.run(w, false, false, run)) continue;
      for (Index k = 0; k < w.length; ++k) {
        left.time_s.push_back(p.time_s(w.from + k));
        left.value.push_back(run.residual[channel * w.length + k]);
      }
    }
  return left;
}

// value ~ a cos(w t) + b sin(w t): both, and the square sum that they take.
struct Sine {
  double hertz = 0, cosine = 0, sine = 0, taken = 0;
  double amplitude() const { return std::hypot(cosine, sine); }
};

Sine fitted(const Leftover& left, double hertz) {
  Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (size_t i = 0; i < left.value.size(); ++i) {
    const double angle = kTwoPi * hertz * left.time_s[i];
    const Eigen::Vector2d wave(std::cos(angle), std::sin(angle));
    gram += wave * wave.transpose(), moment += left.value[i] * wave;
  }
  const Eigen::Vector2d both = gram.ldlt().solve(moment);
  return {hertz, both[0], both[1], both.dot(moment)};
}

// The sine near the mains' frequency that takes most.
Sine sine_near(const Leftover& left, double mains_Hz) {
  const double step_Hz = kStep / std::max(1e-9, left.duration_s());
  Sine best;
  for (double off = -kMainsWidth_Hz; off <= kMainsWidth_Hz; off += step_Hz) {
    const Sine here = fitted(left, mains_Hz + off);
    if (here.taken > best.taken) best = here;
  }
  const auto misses = [&](double hertz) { return -fitted(left, hertz).taken; };
  const double hertz =
      boost::math::tools::brent_find_minima(misses, best.hertz - step_Hz, best.hertz + step_Hz, kBits).first;
  return fitted(left, hertz);
}

void take_out(const Sine& hum, Prepared& p, size_t channel) {
  Vec& y = p.traces[channel].y;
  for (Index i = 0; i < y.size(); ++i) {
    const double angle = kTwoPi * hum.hertz * p.time_s(i);
    y[i] -= hum.cosine * std::cos(angle) + hum.sine * std::sin(angle);
  }
}

bool of_the_mains(const Hum& hum) { return hum.amplitude > 0 && !hum.driven; }

// Of one channel is enough: the mains are taken out of every channel that has them, or they would be said to be that one's.
bool in_the_way(const std::vector<Hum>& hum, const Vec& mean_square) {
  for (size_t c = 0; c < hum.size(); ++c)
    if (of_the_mains(hum[c]) &&
        0.5 * hum[c].amplitude * hum[c].amplitude > kGoodPart * mean_square[static_cast<Index>(c)])
      return true;
  return false;
}

}  // namespace

std::vector<Hum> take_out_hum(const Task& task, const Choice& choice, std::vector<Prepared>& records) {
  const State& state = choice.base;
  const std::vector<Hum>& hum = choice.base_left.hum;
  Evaluator evaluator(task.system, state.model, task.records);
  if (!state.fit.ok || evaluator.massless() || hum.size() != task.records[0].traces.size() ||
      !in_the_way(hum, state.fit.mean_square))
    return {};
  std::vector<std::vector<Sine>> lines(hum.size());  // per channel, per record
  for (size_t c = 0; c < hum.size(); ++c)
    for (size_t r = 0; of_the_mains(hum[c]) && r < records.size(); ++r)
      lines[c].push_back(sine_near(leftover_of(evaluator, records[r], state, r, static_cast<Index>(c)), hum[c].hertz));
  std::vector<Hum> taken(hum.size());
  bool any = false;
  for (size_t c = 0; c < lines.size(); ++c)
    for (size_t r = 0; r < lines[c].size(); ++r) {
      if (!std::isfinite(lines[c][r].amplitude())) continue;
      take_out(lines[c][r], records[r], c);
      const double largest = std::max(taken[c].amplitude, lines[c][r].amplitude());
      taken[c] = hum[c], taken[c].amplitude = largest, any = true;
    }
  if (!any) return {};
  for (Prepared& p : records) renew_motion(p);
  return taken;
}

}  // namespace diagnosis::runs
