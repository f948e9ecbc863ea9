// Friction that turns, holds and lets go; and how what sticks shares its forces.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "simulator.hpp"

namespace diagnosis::runs {
namespace {

constexpr int kSearches = 8;    // for the instant
constexpr double kNear = 1e-3;  // of a friction: what holds it is known no better

}  // namespace

// Accelerations per force: the inverse of the masses, with stuck links as bodies.
Simulator::Yield Simulator::yield_of_present() const {
  Yield of;
  of.yield = mass_.cwiseInverse().asDiagonal();
  for (const Friction& f : friction_)
    if (f.sign == 0) of.held.push_back(&f);
  if (of.held.empty()) return of;
  Mat b = Mat::Zero(nodes_, static_cast<Index>(of.held.size()));
  for (size_t i = 0; i < of.held.size(); ++i) {
    if (of.held[i]->a >= 0) b(of.held[i]->a, static_cast<Index>(i)) += 1;
    if (of.held[i]->b >= 0) b(of.held[i]->b, static_cast<Index>(i)) -= 1;
  }
  const Mat mb = mass_.cwiseInverse().asDiagonal() * b;
  Mat inner = b.transpose() * mb;
  inner.diagonal().array() *= 1 + 1e-12;
  const auto solver = inner.ldlt();
  of.by_hold = solver.solve(mb.transpose());
  of.inner_inverse = solver.solve(Mat::Identity(inner.rows(), inner.cols()));
  of.yield -= mb * of.by_hold;
  return of;
}

void Simulator::renew_yield() {
  if (!yield_old_) return;
  sticks_.clear();
  for (const Friction& f : friction_) sticks_.push_back(f.sign == 0);
  auto found = yields_.find(sticks_);
  if (found == yields_.end()) found = yields_.emplace(sticks_, yield_of_present()).first;
  now_ = &found->second;
  yield_old_ = false;
}

// How the rates of stuck links would change if their DOFs stayed at rest, per unit of the base's acceleration, turned: what their
// DOFs must take part in.
Vec Simulator::with_base() const {
  Vec c = Vec::Zero(static_cast<Index>(now_->held.size()));
  for (size_t i = 0; i < now_->held.size(); ++i)
    c[static_cast<Index>(i)] = now_->held[i]->b == -2 ? 1 : now_->held[i]->a == -2 ? -1 : 0;
  return c;
}

// What holds a stuck link, from the last accelerations(): the force that its ends must exchange.
double Simulator::hold_force(const Friction& f, const Outside& o) const {
  const Index own = std::find(now_->held.begin(), now_->held.end(), &f) - now_->held.begin();
  const double carried = o.a != 0 ? o.a * now_->inner_inverse.row(own).dot(with_base()) : 0;
  return now_->by_hold.row(own).dot(net_) - carried;
}

// A link's rate has come to zero: it sticks, or slides on in the other direction.
void Simulator::turn(Friction& f, double at, Vec& y, Sensitivity* s) {
  const Outside o = outside(at);
  static thread_local Vec before, after;
  accelerations(y, o, before, false);
  const double falling = relative(before, 0, f.a, f.b, o.a);
  const int was = f.sign;
  f.sign = 0, yield_old_ = true;
  accelerations(y, o, after, false);
  const double hold = hold_force(f, o), most = level(f, 0);
  if (std::abs(hold) > most) {
    f.sign = hold > 0 ? 1 : -1, yield_old_ = true;
    if (f.sign == was && std::abs(falling) > 0) f.sign = -was;  // it came here falling
    accelerations(y, o, after, false);
  }
  const double w = relative(y, nodes_, f.a, f.b, o.v);  // what the search for the instant left
  if (f.sign == 0) {
    if (f.a >= 0 && f.b >= 0) {
      const double share = mass_[f.b] / (mass_[f.a] + mass_[f.b]);
      y[nodes_ + f.a] -= share * w, y[nodes_ + f.b] += (1 - share) * w;
    } else if (f.a >= 0) {
      y[nodes_ + f.a] -= w;
    } else if (f.b >= 0) {
      y[nodes_ + f.b] += w;
    }
  }
  if (!s || std::abs(falling) < 1e-12) return;
  Eigen::RowVectorXd g = Eigen::RowVectorXd::Zero(s->cols());
  if (f.a >= 0) g += s->row(nodes_ + f.a);
  if (f.b >= 0) g -= s->row(nodes_ + f.b);
  const Vec jump = (after - before) / falling;
  s->middleRows(nodes_, nodes_) += jump * g;
}

// The first of the stuck links that cannot be held until the end of a substep, and the share of its rest after which it lets go:
// a blow that starts within it passes through to all links in their turn.
std::pair<Simulator::Friction*, double> Simulator::first_to_let_go(const Vec& y0, const Vec& y, double from) {
  std::pair<Friction*, double> first{nullptr, 2};
  if (all_slide()) return first;
  static thread_local Vec acc, middle;
  const auto net_at = [&](const Vec& state, double at) {
    const Outside o = outside(at);
    accelerations(state, o, acc, false);
    return o;
  };
  const auto excess = [&](const Friction& f, const Outside& o) { return std::abs(hold_force(f, o)) - level(f, 0); };
  static thread_local std::vector<std::pair<Friction*, double>>
      loose;  // and by how much what would hold them exceeds their friction
  loose.clear();
  const Outside last = net_at(y, 1);
  for (Friction& f : friction_)
    if (f.sign == 0 && excess(f, last) > 0) loose.push_back({&f, excess(f, last)});
  for (auto [f, above] : loose) {
    double low = 0, high = 1, share = 0, below = excess(*f, net_at(y0, from));
    if (below >= 0) return {f, 0};
    bool was_above = true;
    for (int search = 0; search < kSearches; ++search) {  // the false position, drawn to the end that stays
      share = low + (high - low) * below / (below - above);
      middle = y0;
      step(from, share * (1 - from), middle, nullptr);
      const double value = excess(*f, net_at(middle, from + share * (1 - from)));
      if (std::abs(value) < kNear * level(*f, 0)) break;
      const bool is_above = value > 0;
      if (search > 0 && is_above == was_above) (is_above ? below : above) *= 0.5;
      (is_above ? high : low) = share, (is_above ? above : below) = value, was_above = is_above;
    }
    if (share < first.second) first = {f, share};
  }
  return first;
}

void Simulator::let_go(Friction& f, double at, const Vec& y) {
  const Outside o = outside(at);
  static thread_local Vec acc;
  accelerations(y, o, acc, false);
  f.sign = hold_force(f, o) > 0 ? 1 : -1, yield_old_ = true;
}

}  // namespace diagnosis::runs
