#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "simulator.hpp"

// Friction that turns, holds and lets go.
namespace diagnosis::runs {

// What holds a stuck link, from the last accelerations(): the force that its ends must exchange.
double Simulator::hold_force(const Friction& f, const Outside& o) const {
  const Index own = std::find(held_.begin(), held_.end(), &f) - held_.begin();
  const double carried = o.a != 0 ? o.a * inner_inverse_.row(own).dot(with_base()) : 0;
  return by_hold_.row(own).dot(net_) - carried;
}

// A link's rate has come to zero: it sticks, or slides on in the other direction.
void Simulator::turn(Friction& f, double at, Vec& y, Sensitivity* s) {
  const Outside o = outside(at);
  Vec before, after;
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

void Simulator::release(const Vec& y, double at) {
  bool any = false;
  for (const Friction& f : friction_) any = any || f.sign == 0;
  if (!any) return;
  const Outside o = outside(at);
  Vec acc;
  accelerations(y, o, acc, false);
  for (Friction& f : friction_) {
    if (f.sign != 0) continue;
    const double hold = hold_force(f, o);
    if (std::abs(hold) <= level(f, 0)) continue;
    f.sign = hold > 0 ? 1 : -1, yield_old_ = true;
    return;  // the others are looked at after the next step
  }
}

}  // namespace diagnosis::runs
