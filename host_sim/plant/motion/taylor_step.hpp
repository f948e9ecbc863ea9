// The motion of a rig of springs, viscous dampers and constant friction between two events, as a Taylor series in time.
//
// M x'' = f(t) - sum over links of (k u + c w + F sign), u and w the link's elongation and rate. With x(t + theta h) =
// sum of X_k theta^k and f likewise,
//   X_{k+2} = h^2 / ((k + 1) (k + 2)) M^-1 (f_k - sum over links of (k U_k + c (k + 1) U_{k+1} / h + F sign where k = 0)).
// The series is summed until what follows is below the rounding of a double: no error control, no tolerance.
#pragma once
#include <vector>

#include "host_sim/plant/motion/equations.hpp"

namespace host_sim {

class TaylorStep {
 public:
  // equations.linear_between_events(); both outlive this.
  TaylorStep(const Equations& equations, const Excitation& excitation);

  // Up to when the excitation is one series; t_s itself: it is none.
  double smooth_until(double t_s) const;
  // Over a longer step the terms grow before they shrink, and digits are lost.
  double longest_step_s() const { return longest_step_s_; }
  // From the state y at t_s over step_s, which the excitation must be smooth for. False: the series does not end.
  bool expand(double t_s, double step_s, const double* y, const Modes& modes, const MotionScale& scale);
  // y at t_s + theta step_s, 0 <= theta <= 1.
  void state(double theta, double* y) const;
  // Where in the step the rate of a link, of the given sign at both ends, is nearest to zero; 1: at an end.
  double nearest_to_rest(size_t link, int sign) const;

 private:
  struct Link {
    size_t a, b;
    double stiffness = 0.0, viscous = 0.0, friction = 0.0;
  };
  struct Drive {
    size_t node;
    const Signal* signal;
    double c[33];
  };
  static constexpr int kMost = 32;  // order of the series
  double* row(int k) { return &x_[static_cast<size_t>(k) * nodes_]; }
  const double* row(int k) const { return &x_[static_cast<size_t>(k) * nodes_]; }
  struct End {  // of a link, at a mass
    size_t a, b, link;
    double stiffness, viscous, friction, sign;  // sign: of the link's force at the mass, taken off
  };
  double* drive_row(int k) { return &drive_[static_cast<size_t>(k) * nodes_]; }
  void set_drives(double t_s, double step_s);
  template <typename Take>
  void each_net_force(int k, const Modes& modes, Take take);
  double accelerate(int k, const Modes& modes, double factor, double* next);

  const Equations& equations_;
  size_t masses_, nodes_;  // masses, ground, base
  std::vector<Link> links_;
  std::vector<Drive> drives_;
  Drive base_{};
  double longest_step_s_, step_s_ = 1.0;
  int order_ = 1, driven_ = 0;            // of the series; rows that the drives stand in
  std::vector<double> mass_, x_, drive_;  // x_, drive_: a row of nodes for every order
  std::vector<End> ends_;                 // of one mass after the other, in the links' order
  bool two_ends_ = true;                  // every mass has two, as in a chain between walls
  std::vector<size_t> ends_of_;           // where those of a mass end
  std::vector<double> body_sum_, body_mass_;
  std::vector<size_t> body_;  // empty: nothing is stuck
};

}  // namespace host_sim
