// One model on one record: free runs with their exact sensitivities to states and parameters.
//
// State y = [x of every node | v of every node | z of every presliding term]; nodes are the DOFs and the hidden masses.
// Between two events the right-hand side is smooth and one Runge-Kutta step of order 4 goes from instant to instant; a
// link whose rate passes zero stops there, sticks where its friction holds it, and slides on else. The sensitivities
// jump there as the trajectory's kink demands (saltation matrix).
#pragma once
#include <array>
#include <map>
#include <memory>

#include "model.hpp"

namespace diagnosis::runs {

// How states answer to states and parameters at the start, a row per state: rows are what a step combines.
using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
// to.row(r) += sum over c of from(r, c) of.row(c), of the first columns of `from`. What links do not couple is nought.
void add_product(const Mat& from, const Sensitivity& of, Sensitivity& to);
// What has `slopes` by the state and by the parameters (the last columns), by what the state answers to.
void answer(const Mat& slopes, const Sensitivity& of_state, Sensitivity& rows);

class Simulator {
 public:
  Simulator(const System& system, const Model& model, const Prepared& record);
  Simulator(const Simulator&) = delete;  // points into itself
  Simulator& operator=(const Simulator&) = delete;
  Index states() const { return 2 * nodes_ + hysteresis_; }
  Index nodes() const { return nodes_; }
  Index parameters() const { return parameters_; }
  bool sound() const { return sound_; }  // every node has mass, and steps are short enough for every damper
  bool massless() const { return massless_; }
  // Whether one product carries a state, and its sensitivity, over a step: what advance() asks of accelerations() is not needed then.
  bool affine() const { return affine_; }

  // The state at a sample from the record's guess.
  Vec guessed_state(Index sample) const;
  void start(Index sample, const Vec& y);  // sets modes
  // From a sample to the next; `sensitivity` (states x (states + parameters)), where given, is carried on from what
  // it is.
  bool advance(Index sample, Vec& y, Sensitivity* sensitivity);
  // Accelerations against the ground at the present state, and their sensitivity (nodes x (states + parameters))
  // where wanted.
  void accelerations(Index sample, const Vec& y, Vec& a, Mat* slopes);
  // How those accelerations answer to states and parameters at the start: their slopes, from the last accelerations(), times how
  // the state does. The step from there goes on with them.
  const Sensitivity& rows_of_accelerations(const Mat& slopes, const Sensitivity& of_state);
  const Mat& yield() const { return now_->yield; }  // accelerations per force on each node, at the last accelerations()

  // Forces of a model without masses under given motion, and their slopes by the parameters (dofs x parameters).
  void forces_of_motion(const Mat& x, const Mat& v, const Mat& a, Mat& force, std::vector<Mat>& slopes) const;
  double elongation(const Vec& y, size_t link, Index sample) const;

 private:
  struct Element {
    Kind kind;
    int a, b;  // nodes; -1 ground, -2 base
    double value, shape, shape2;
    Index by_value = -1, by_shape = -1;
    Index z = -1;  // presliding: its state
    Index by_shape2 = -1;
    bool linear = false;  // then its law's slopes are these everywhere
    double by_u = 0, by_w = 0;
  };
  struct Friction {
    int a, b;
    int sign = 0;  // of the rate; 0: stuck
    std::vector<size_t> levels;
  };
  struct Outside {  // what acts from outside at an instant
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 48, 1> force;
    double x = 0, v = 0, a = 0;  // of the base
    double carried = 0;          // acceleration of the base against which the nodes move
    double jerk = 0;             // of the base
    double t_s = 0;
  };
  // Of a substep of springs, dampers and dry friction (affine.cpp). What it takes: the state, every drive at its start,
  // middle and end, and a force on each node that stays.
  struct Affine {
    Mat map, by_state;  // to the state at its end; its first columns alone
    Mat slopes;         // of the map: a row per state and parameter, the parameters of a state together
  };
  // How the nodes give way while the same links stick.
  struct Yield {
    std::vector<const Friction*> held;  // links that stick
    Mat yield;                          // accelerations per force on each node
    Mat by_hold, inner_inverse;  // what holds them per force on each node (links x nodes); inverse of their inertia
    Affine affine;               // empty until it is asked for
  };
  void compile(const System& system, const Model& model);
  double steps_per_second() const;
  struct Rates;
  void join(const Element& e, double stiffness, double damping, Mat& rates) const;
  Rates rates(const Mat& yield) const;
  Yield yield_of_present() const;
  bool all_lines() const;
  void make_affine(Yield& of) const;
  const Affine* affine_now();
  bool all_slide() const;
  void affine_step(const Affine& affine, Vec& y, Sensitivity* s) const;
  void upsample(const Model& model);
  void upsample_base(const Model& model);
  using Fine = std::shared_ptr<const Vec>;  // on the fine instants: 2 substeps per sample
  Fine upsampled(const Vec& y, double late_s) const;
  Outside outside(double share) const;  // of the present substep
  // Of what drives the rig, on the fine instants: held from sample to sample, or the parabola through the present substep.
  double drive_at(const Vec& fine, double share) const;
  double base_rate(double share) const;
  double bent_so_far(const Element& e, Index sample) const;
  double relative(const Vec& y, Index offset, int a, int b, double base) const;
  void accelerations(const Vec& y, const Outside& o, Vec& acc, bool slopes);
  void pull_elements(const Vec& y, const Outside& o, bool slopes);
  void pull_friction(const Vec& y, const Outside& o, bool slopes);
  void pull(const Element& e, const LawValue& f, const Outside& o, bool slopes);
  void add_slope(int node, Index column, double value);
  void add_slopes(const Element& e, Index column, double value);  // of what pulls its ends together by that
  void finish_slopes(const Outside& o, const Vec& acc);
  double level(const Friction& f, double w) const;
  void renew_yield();
  double hold_force(const Friction& f, const Outside& o) const;
  Vec with_base() const;
  void bend(const Vec& start, Vec& y, const Outside& o0, const Outside& o1, const Sensitivity* s0,
            Sensitivity* s) const;
  void step(double from, double length, Vec& y, Sensitivity* s);
  void carry(int stage, const Sensitivity& from, double step_s, Sensitivity& to) const;
  void turn(Friction& f, double at, Vec& y, Sensitivity* s);
  std::pair<Friction*, double> first_to_turn(const Vec& y0, const Vec& y, double from);
  double share_to_turn(const Friction& f, const Vec& y0, double from, double share);
  std::pair<Friction*, double> first_to_let_go(const Vec& y0, const Vec& y, double from);
  void let_go(Friction& f, double at, const Vec& y);

  const Prepared& record_;
  Index nodes_ = 0, hysteresis_ = 0, parameters_ = 0;
  bool sound_ = true, massless_ = false;
  std::vector<Element> elements_;
  std::vector<Friction> friction_;
  Vec mass_, lightness_;                     // its inverse
  std::vector<std::vector<Index>> by_mass_;  // per node: parameters that add to its mass
  std::vector<std::pair<int, int>> link_ends_;
  int substeps_ = 1;
  std::vector<Fine> fine_;  // force per node with one
  std::vector<int> fine_node_;
  struct ForceFault {
    Kind kind;
    size_t fine;
    double frequency;    // of a hum, Hz; of a dead band, N
    Index by_value;      // the parameter that its slope is by: the coefficient, or
    bool of_width;       // the logarithm of a dead band's width,
    double coefficient;  // beside this share of the band
  };
  std::vector<ForceFault> faults_;
  std::vector<Vec> fine_slope_;  // of faults_, on the same instants
  Fine base_x_, base_v_, base_a_;
  Vec base_jerk_;  // where the base's delay is fitted
  Index by_base_delay_ = -1;
  Index at_ = 0;  // first fine instant of the present substep
  // A force that is held over the samples of the record acts, over those of a record that was thinned out, as one that is late
  // by half of one of them; but an acceleration shows it at once.
  bool steps_ = false, late_ = false;
  Mat slope_x_, alone_;
  Vec net_;
  Sensitivity ka_[4], stage_[4];  // of accelerations and states, at the stages of a step
  Vec acc_[4];
  std::map<std::vector<char>, Yield> yields_;  // by which links stick
  std::vector<char> sticks_;                   // the key of the present one,
  Yield* now_ = nullptr;                       // which is this,
  bool yield_old_ = true;                      // unless a link has turned, been stopped or let go since
  bool affine_ = false;                        // nothing but such elements
  // The state whose accelerations stand in acc_[0], their slopes in slope_x_ where there are some, since accelerations(sample, ..):
  // the step from there begins with them.
  struct Begun {
    bool is = false, slopes = false;
    Index at = 0;
    Vec y;
    const Sensitivity* rows = nullptr;  // of which ka_[0] is made already
  } begun_;
};

}  // namespace diagnosis::runs
