#include "tune.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "candidates.hpp"

namespace diagnosis {
namespace {

constexpr int kSteps = 2, kMostRounds = 12;
constexpr int kSpans = 4;  // of a record, each from its own measured state: shorter runs lose less phase

struct Knob {
  size_t term = 0;
  bool shape = false;
  double step = 0;  // for the slope
};

std::vector<Knob> knobs_of(const std::vector<ActiveTerm>& model) {
  std::vector<Knob> list;
  for (size_t i = 0; i < model.size(); ++i) {
    const ActiveTerm& t = model[i];
    if (t.companion >= 0) continue;
    if (!t.known && t.host < 0) list.push_back({i, false, std::max({1e-4 * std::abs(t.value), 0.1 * t.std, 1e-12})});
    if (t.added && CandidateBank::has_shape(t.term)) list.push_back({i, true, 0.02 * t.term.shape});
  }
  return list;
}

void turn(std::vector<ActiveTerm>& model, const Knob& knob, double by) {
  ActiveTerm& t = model[knob.term];
  if (knob.shape) {
    double& shape = t.term.shape;
    shape *= std::exp(std::clamp(by / shape, -1.0, 1.0));
    return;
  }
  t.value += by;
  for (ActiveTerm& guest : model)
    if (guest.host == static_cast<int>(knob.term)) guest.value = guest.host_sign * t.value;
}

// Errors over all records' equation spans, one after the other; empty where a run does not stay finite.
Series errors_of(const System& system, const std::vector<ActiveTerm>& model, const std::vector<FusedRecord>& records) {
  Series all;
  for (const FusedRecord& f : records) {
    const Eigen::Index n = static_cast<Eigen::Index>(f.samples);
    const Eigen::Index ramp = static_cast<Eigen::Index>((f.outer.weight.array() < 1).count() / 2 + 8);
    const Eigen::Index span = (n - 2 * ramp) / kSpans;
    for (int i = 0; i < kSpans; ++i) {
      const Series one = run_errors(system, model, f, ramp + i * span, ramp + (i + 1) * span, kSteps);
      if (one.size() == 0 || !one.allFinite()) return Series();
      const Eigen::Index before = all.size();
      all.conservativeResize(before + one.size());
      all.tail(one.size()) = one;
    }
  }
  return all;
}

}  // namespace

double tune(const System& system, std::vector<ActiveTerm>& model, const std::vector<FusedRecord>& records) {
  const std::vector<ActiveTerm> start = model;
  const std::vector<Knob> knobs = knobs_of(model);
  Series error = errors_of(system, model, records);
  if (error.size() == 0) return 1e6;
  for (int round = 0; round < kMostRounds; ++round) {
    Eigen::MatrixXd slope(error.size(), static_cast<Eigen::Index>(knobs.size()));
    for (size_t k = 0; k < knobs.size(); ++k) {
      std::vector<ActiveTerm> moved = model;
      turn(moved, knobs[k], knobs[k].step);
      const Series e = errors_of(system, moved, records);
      if (e.size() == 0) return 100 * std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
      slope.col(static_cast<Eigen::Index>(k)) = e - error;  // per step
    }
    Eigen::MatrixXd gram = slope.transpose() * slope;
    gram.diagonal() *= 1 + 1e-9;
    const Eigen::VectorXd way = gram.ldlt().solve(-slope.transpose() * error);
    const double before = error.squaredNorm();
    bool better = false;
    for (double part = 1; part > 0.05 && !better; part *= 0.4) {
      std::vector<ActiveTerm> moved = model;
      for (size_t k = 0; k < knobs.size(); ++k)
        turn(moved, knobs[k], part * way[static_cast<Eigen::Index>(k)] * knobs[k].step);
      const Series e = errors_of(system, moved, records);
      if (e.size() == 0 || !(e.squaredNorm() < before)) continue;
      model = moved, error = e, better = true;
    }
    if (!better || error.squaredNorm() > 0.98 * before) break;
  }
  for (size_t i = 0; i < model.size(); ++i) model[i].std = std::hypot(model[i].std, model[i].value - start[i].value);
  return 100 * std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
}

}  // namespace diagnosis
