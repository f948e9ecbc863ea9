// The motion of a link, as the guesses of its ends have it.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// &Guess::x: its elongation in a record; &Guess::v, &Guess::a: the first and second derivative of that. An end that is not known, as the
// ground, does not move.
inline Vec motion_of(const rig_file::Link& link, const Prepared& p, Vec Guess::*quantity) {
  const auto add = [&](int end, double sign, Vec& sum) {
    if (end == rig_file::kGround) return;
    const Guess& g = p.guess[end == rig_file::kBase ? p.guess.size() - 1 : static_cast<size_t>(end - 1)];
    if (g.given) sum += sign * (g.*quantity);
  };
  Vec sum = Vec::Zero(p.samples);
  add(link.a, 1, sum), add(link.b, -1, sum);
  return sum;
}

// What unit coefficients of a link take over all records' motion, to a sample's period: sums of w^2 and of |w|, w its rate.
struct UnitWork {
  double viscous = 0, coulomb = 0;
};

inline UnitWork unit_work_of(const rig_file::Link& link, const std::vector<Prepared>& records) {
  UnitWork work;
  for (const Prepared& p : records) {
    const Vec rate = motion_of(link, p, &Guess::v);
    work.viscous += rate.squaredNorm(), work.coulomb += rate.lpNorm<1>();
  }
  return work;
}

}  // namespace diagnosis::runs
