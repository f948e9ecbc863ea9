#include "with_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "../candidates/pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kFewestWindows = 10;  // from which on a mean over windows has a scatter
constexpr size_t kOthers = 4;          // windows that stand for chance
constexpr Index kRowsPerColumn = 12;   // fewer and columns take noise and motion alike
constexpr double kMostNumbers = 3e6;   // of all bases together, 24 MB: some hundred windows of a long recording

using Terms = std::vector<Term>;

void on_links(const System& system, Kind kind, Terms& list) {
  for (size_t l = 0; l < system.known_links; ++l) list.push_back(on_link(kind, static_cast<int>(l)));
}

// Forces that depend on the motion.
Terms of_motion(const System& system, const Model& model) {
  Terms list;
  on_links(system, Kind::kMissingViscous, list), on_links(system, Kind::kStiffnessError, list);
  for (const ModelTerm& t : model)
    if (t.term.kind == Kind::kMass) list.push_back(on_dof(Kind::kMassError, t.term.dof));
  on_links(system, Kind::kMissingCoulomb, list), on_links(system, Kind::kCubicStiffness, list);
  on_links(system, Kind::kQuadraticStiffness, list);
  return list;
}

// Springs and dampers that change within a window.
Terms of_time(const System& system, double window_s) {
  Terms list;
  for (double waves : {1.0, 2.0, 3.0})
    for (double phase : {0.0, 0.25 * kTwoPi}) {
      const size_t from = list.size();
      on_links(system, Kind::kStiffnessError, list), on_links(system, Kind::kMissingViscous, list);
      for (size_t i = from; i < list.size(); ++i) list[i].shape = waves / window_s, list[i].shape2 = phase;
    }
  return list;
}

// Orthonormal rows that span those of m.
Mat basis_of(const Mat& m) {
  const Vec size = m.rowwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::ColPivHouseholderQR<Mat> qr((size.asDiagonal() * m).transpose());
  return (qr.householderQ() * Mat::Identity(m.cols(), qr.rank())).transpose();
}

// Every so many of the windows that their bases take no more room than they may.
std::vector<Window> some_of(const std::vector<Window>& windows, double numbers_each) {
  const double all = numbers_each * static_cast<double>(windows.size());
  const size_t every =
      std::clamp<size_t>(static_cast<size_t>(1 + all / kMostNumbers), 1, windows.size() / kFewestWindows);
  std::vector<Window> some;
  for (size_t i = 0; i < windows.size(); i += every) some.push_back(windows[i]);
  return some;
}

WithMotion goes_with(const System& system, const std::vector<Prepared>& records, const State& state, Terms terms) {
  WithMotion out;
  Index length = state.seen[0].length;
  for (const Window& w : state.seen) length = std::min(length, w.length);
  const Index channels = state.fit.mean_square.size();
  const size_t most = static_cast<size_t>(length * channels / kRowsPerColumn);
  if (terms.empty() || terms.size() > most) return out;  // such short windows do not tell
  const std::vector<Window> windows =
      some_of(state.seen, static_cast<double>(terms.size()) * static_cast<double>(length * channels));
  std::vector<Vec> residual;
  std::vector<Mat> basis;
  Pass pass(system, records, state.model, windows, state.fit);
  const bool fine = pass.over(terms, [&](size_t i, const Mat& columns, const Sensitivity&, const Vec& rest) {
    const Index whole = windows[i].length;
    Mat c(columns.rows(), channels * length);
    Vec r(channels * length);
    for (Index k = 0; k < channels; ++k) {
      c.middleCols(k * length, length) = columns.middleCols(k * whole, length);
      r.segment(k * length, length) = rest.segment(k * whole, length);
    }
    basis.push_back(basis_of(c)), residual.push_back(r);
  });
  if (!fine) return out;
  const size_t n = residual.size();
  double total = 0, more = 0, square = 0, chance = 0, sum = 0, sum_square = 0;
  for (const Vec& r : residual) total += r.squaredNorm();
  for (size_t i = 0; i < n; ++i) {
    double other = 0;
    for (size_t k = 1; k <= kOthers; ++k) other += (basis[(i + k * n / (kOthers + 1)) % n] * residual[i]).squaredNorm();
    other /= kOthers;
    const double mine = (basis[i] * residual[i]).squaredNorm() - other;
    more += mine, square += mine * mine, chance += other;
    const double fraction = mine / std::max(1e-300, residual[i].squaredNorm());  // one loud window is not many
    sum += fraction, sum_square += fraction * fraction;
  }
  const double count = static_cast<double>(n), mean = more / count;
  const double se = std::sqrt(std::max(0.0, square / count - mean * mean) / (count - 1));
  const double left_by_chance = std::max(0.1, 1 - chance / total);
  out.known = true;
  out.share = more / total / left_by_chance, out.std = se * count / total / left_by_chance;
  const double mean_fraction = sum / count;
  const double spread = std::sqrt(std::max(0.0, sum_square / count - mean_fraction * mean_fraction) / (count - 1));
  out.z = normal_deviate(mean_fraction / std::max(spread, 1e-300), count - 1);
  return out;
}

}  // namespace

WithMotion with_motion(const System& system, const std::vector<Prepared>& records, const State& state) {
  if (state.seen.size() < kFewestWindows) return {};
  const WithMotion by_motion = goes_with(system, records, state, of_motion(system, state.model));
  const double window_s = static_cast<double>(state.seen[0].length) * records[0].step_s;
  const WithMotion by_time = goes_with(system, records, state, of_time(system, window_s));
  return by_time.z > by_motion.z ? by_time : by_motion;
}

namespace {

// Both less their means over the windows of each record; how many records have some.
size_t about_each_record(const State& state, Vec& motion, Vec& error) {
  std::map<size_t, std::vector<Index>> windows;
  for (size_t i = 0; i < state.seen.size(); ++i) windows[state.seen[i].record].push_back(static_cast<Index>(i));
  for (const auto& [record, own] : windows)
    for (Vec* y : {&motion, &error}) {
      double mean = 0;
      for (const Index i : own) mean += (*y)[i] / static_cast<double>(own.size());
      for (const Index i : own) (*y)[i] -= mean;
    }
  return windows.size();
}

}  // namespace

WithLoudness with_loudness(const std::vector<Prepared>& records, const State& state) {
  WithLoudness out;
  const size_t n = state.seen.size(), channels = records[0].traces.size();
  if (n < kFewestWindows || !state.fit.ok) return out;
  std::vector<double> all(channels, 0.0);  // mean squares of the channels over all records
  for (size_t c = 0; c < channels; ++c)
    for (const Prepared& p : records) all[c] += (p.traces[c].y.array() - p.traces[c].y.mean()).square().mean();
  Vec motion(static_cast<Index>(n)), error(static_cast<Index>(n));
  for (size_t i = 0; i < n; ++i) {
    const Window& w = state.seen[i];
    double sum = 1e-300, left = 1e-300;
    for (size_t c = 0; c < channels; ++c) {
      const auto y = records[w.record].traces[c].y.segment(w.from, w.length);
      if (all[c] > 0) sum += (y.array() - y.mean()).square().mean() / all[c];
    }
    for (size_t b = i * state.fit.parts; b < (i + 1) * state.fit.parts; ++b)
      left += state.fit.block_ss[b].cwiseQuotient(state.fit.mean_square).sum();
    left /= static_cast<double>(w.length);
    motion[static_cast<Index>(i)] = std::log(sum), error[static_cast<Index>(i)] = std::log(left);
  }
  // Of two records the louder one may have the louder noise: a sensor's range goes with the level, and its noise with the range.
  const size_t apart = about_each_record(state, motion, error);
  const double mean = error.array().exp().mean();
  std::vector<double> levels(error.data(), error.data() + error.size());
  std::nth_element(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(n / 4), levels.end());
  out.quiet_share = std::min(1.0, std::exp(levels[n / 4]) / mean);
  const double dof = static_cast<double>(n) - 1 - static_cast<double>(apart);
  const double size = motion.norm() * error.norm();
  const double r = size > 0 ? std::min(motion.dot(error) / size, 1 - 1e-12) : 0;
  if (dof >= 1) out.z = normal_deviate(r * std::sqrt(dof / (1 - r * r)), dof);
  return out;
}

}  // namespace diagnosis::runs
