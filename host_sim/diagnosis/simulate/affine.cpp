#include <algorithm>
#include <array>

#include "simulator.hpp"

// A substep of a few masses on springs, dampers and dry friction: its four stages are one product, made once.
namespace diagnosis::runs {
namespace {

constexpr Index kMostNodes = 6;  // beyond it the few forces of each stage are fewer numbers than a full matrix

// Powers of h A, and their slope by a parameter.
struct Powers {
  std::array<Mat, 5> of, slope;
};

Powers powers(const Mat& a, const Mat& slope) {
  Powers p;
  p.of[0] = Mat::Identity(a.rows(), a.cols()), p.slope[0] = Mat::Zero(a.rows(), a.cols());
  for (size_t i = 1; i < p.of.size(); ++i)
    p.of[i] = p.of[i - 1] * a, p.slope[i] = p.slope[i - 1] * a + p.of[i - 1] * slope;
  return p;
}

Mat weighted(const std::array<Mat, 5>& powers, const std::array<double, 5>& weight) {
  Mat sum = weight[0] * powers[0];
  for (size_t i = 1; i < powers.size(); ++i)
    if (weight[i] != 0) sum += weight[i] * powers[i];
  return sum;
}

// What the step of order 4 makes of A y + b, with b at its start, in its middle and at its end.
constexpr std::array<double, 5> kOfState = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
constexpr std::array<std::array<double, 5>, 3> kOfDrive = {
    {{1.0 / 6, 1.0 / 6, 1.0 / 12, 1.0 / 24, 0}, {2.0 / 3, 1.0 / 3, 1.0 / 12, 0, 0}, {1.0 / 6, 0, 0, 0, 0}}};
constexpr std::array<double, 5> kOfStay = {1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 0};  // of the same b all the time: their sum

bool is_dry(Kind kind) { return kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb; }

// The map of a step of h seconds, or its slope by a parameter; nodes: where the drives act.
Mat map_of(const Powers& by, bool slope, double h, const Mat& force, const Mat& force_slope,
           const std::vector<int>& nodes) {
  const Index ns = force.rows(), n = force.cols(), drives = static_cast<Index>(nodes.size());
  const auto of_force = [&](const std::array<double, 5>& weight) -> Mat {
    if (!slope) return h * weighted(by.of, weight) * force;
    return h * (weighted(by.slope, weight) * force + weighted(by.of, weight) * force_slope);
  };
  Mat map(ns, ns + 3 * drives + n);
  map.leftCols(ns) = weighted(slope ? by.slope : by.of, kOfState);
  for (size_t at = 0; at < kOfDrive.size(); ++at) {
    const Mat answer = of_force(kOfDrive[at]);
    for (Index d = 0; d < drives; ++d)
      map.col(ns + 3 * d + static_cast<Index>(at)) = answer.col(nodes[static_cast<size_t>(d)]);
  }
  map.rightCols(n) = of_force(kOfStay);
  return map;
}

}  // namespace

// Rates of the state by the state and by forces on the nodes, and their slopes by each parameter.
struct Simulator::Rates {
  Mat by_state, by_force;
  std::vector<Mat> state_slopes, force_slopes;
};

bool Simulator::all_slide() const {
  return std::none_of(friction_.begin(), friction_.end(), [](const Friction& f) { return f.sign == 0; });
}

void Simulator::join(const Element& e, double stiffness, double damping, Mat& rates) const {
  for (int side = 0; side < 2; ++side) {
    const int node = side == 0 ? e.a : e.b, other = side == 0 ? e.b : e.a;
    if (node < 0) continue;
    const double ku = lightness_[node] * stiffness, cw = lightness_[node] * damping;
    rates(nodes_ + node, node) -= ku, rates(nodes_ + node, nodes_ + node) -= cw;
    if (other >= 0) rates(nodes_ + node, other) += ku, rates(nodes_ + node, nodes_ + other) += cw;
  }
}

// yield: of the nodes, which share their forces where a link sticks.
Simulator::Rates Simulator::rates(const Mat& yield) const {
  const Index n = nodes_;
  const size_t count = static_cast<size_t>(parameters_);
  Rates r{Mat::Zero(2 * n, 2 * n), Mat::Zero(2 * n, n), std::vector<Mat>(count, Mat::Zero(2 * n, 2 * n)),
          std::vector<Mat>(count, Mat::Zero(2 * n, n))};
  r.by_state.topRightCorner(n, n).setIdentity(), r.by_force.bottomRows(n) = yield;
  for (const Element& e : elements_) {
    if (is_dry(e.kind)) continue;
    const bool resonance = e.kind == Kind::kResonance;
    const double omega = kTwoPi * e.shape, k = resonance ? omega * omega : e.by_u,
                 c = resonance ? 2 * e.shape2 * omega : e.by_w;
    join(e, e.value * k, e.value * c, r.by_state);
    if (e.by_value >= 0) join(e, k, c, r.state_slopes[static_cast<size_t>(e.by_value)]);
    if (resonance && e.by_shape >= 0)
      join(e, 2 * e.value * k, e.value * c, r.state_slopes[static_cast<size_t>(e.by_shape)]);
    if (resonance && e.by_shape2 >= 0) join(e, 0, e.value * c, r.state_slopes[static_cast<size_t>(e.by_shape2)]);
  }
  const Mat shared = yield * mass_.asDiagonal();  // of what each node would do alone
  const auto share = [&](Mat& rates) { rates.bottomRows(n) = (shared * rates.bottomRows(n)).eval(); };
  share(r.by_state);
  for (Mat& slopes : r.state_slopes) share(slopes);
  for (Index node = 0; node < n; ++node)
    for (Index p : by_mass_[static_cast<size_t>(node)]) {
      r.state_slopes[static_cast<size_t>(p)].bottomRows(n) -= yield.col(node) * r.by_state.row(n + node);
      r.force_slopes[static_cast<size_t>(p)].bottomRows(n) -= yield.col(node) * r.by_force.row(n + node);
    }
  return r;
}

bool Simulator::all_lines() const {
  const bool alone = !record_.guess.back().given && faults_.empty() && by_base_delay_ < 0 && !record_.base.ridden;
  const bool lines = std::all_of(elements_.begin(), elements_.end(), [](const Element& e) {
    return e.linear || e.kind == Kind::kResonance || is_dry(e.kind);
  });
  return sound_ && alone && lines && nodes_ <= kMostNodes;
}

void Simulator::make_affine(Yield& of) const {
  const double h = record_.step_s / substeps_;
  const Rates r = rates(of.yield);
  const Mat ha = h * r.by_state, nothing = Mat::Zero(states(), states());
  Affine& affine = of.affine;
  affine.map = map_of(powers(ha, nothing), false, h, r.by_force, nothing, fine_node_);
  affine.by_state = affine.map.leftCols(states());
  affine.slopes.resize(states() * parameters_, affine.map.cols());
  for (Index p = 0; p < parameters_; ++p) {
    const size_t at = static_cast<size_t>(p);
    const Mat slope = map_of(powers(ha, h * r.state_slopes[at]), true, h, r.by_force, r.force_slopes[at], fine_node_);
    for (Index row = 0; row < states(); ++row) affine.slopes.row(row * parameters_ + p) = slope.row(row);
  }
}

// For a whole substep from where it is; none where it is not affine.
const Simulator::Affine* Simulator::affine_now() {
  if (!affine_) return nullptr;
  renew_yield();
  if (now_->affine.map.size() == 0) make_affine(*now_);
  return &now_->affine;
}

void Simulator::affine_step(const Affine& affine, Vec& y, Sensitivity* s) const {
  static thread_local Vec taken, moved;
  static thread_local Sensitivity next;
  const Index n = nodes_, ns = 2 * n, stay = affine.map.cols() - n;
  taken.setZero(affine.map.cols());
  taken.head(ns) = y;
  for (size_t d = 0; d < fine_.size(); ++d)
    for (Index at = 0; at < 3; ++at)
      taken[ns + 3 * static_cast<Index>(d) + at] = drive_at(*fine_[d], 0.5 * static_cast<double>(at));
  for (const Friction& f : friction_) {
    const double force = f.sign * level(f, 0);
    if (f.a >= 0) taken[stay + f.a] -= force;
    if (f.b >= 0) taken[stay + f.b] += force;
  }
  y.noalias() = affine.map * taken;
  if (!s) return;
  next.setZero(s->rows(), s->cols());
  moved.noalias() = affine.slopes * taken;
  for (Index r = 0; r < ns; ++r) next.row(r).tail(parameters_) = moved.segment(r * parameters_, parameters_);
  for (const Friction& f : friction_)
    for (size_t i : f.levels) {
      const Index column = ns + elements_[i].by_value;
      if (elements_[i].by_value < 0) continue;
      if (f.a >= 0) next.col(column) -= f.sign * affine.map.col(stay + f.a);
      if (f.b >= 0) next.col(column) += f.sign * affine.map.col(stay + f.b);
    }
  add_product(affine.by_state, *s, next);
  s->swap(next);
}

}  // namespace diagnosis::runs
