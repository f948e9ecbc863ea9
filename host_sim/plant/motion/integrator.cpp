#include "host_sim/plant/motion/integrator.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/plant/motion/integrator_working.hpp"
#include "host_sim/plant/motion/short_vector.hpp"

namespace host_sim {
// Before anything has moved: what the present acceleration and the peak force do to each mass within a sample period.
void Integrator::Working::first_scale() {
  const size_t n = equations.masses();
  scale.assign(equations.states(), 1.0);
  equations.derivative(t, y.data(), force.data(), base, modes, dy.data());
  double largest_x = 0.0, largest_v = 0.0;
  for (size_t i = 0; i < n; ++i) {
    const bool has_force = i < excitation.force_N.size() && excitation.force_N[i];
    const double peak = has_force ? excitation.force_N[i]->peak() / equations.mass(i) : 0.0;
    const double v = std::max(peak, std::fabs(dy[n + i])) * period;
    largest_x = std::max({largest_x, std::fabs(y[i]), v * period});
    largest_v = std::max({largest_v, std::fabs(y[n + i]), v});
  }
  if (excitation.base_m) largest_x = std::max(largest_x, excitation.base_m->peak());
  if (largest_x == 0.0) largest_x = largest_v > 0.0 ? largest_v * period : 1e-12;
  if (largest_v == 0.0) largest_v = largest_x;  // 1 rad/s: grows with the motion
  for (size_t i = 0; i < n; ++i) {
    scale[i] = largest_x;
    scale[n + i] = largest_v;
  }
  double largest_force = 0.0;
  for (const SignalPtr& force_signal : excitation.force_N)
    if (force_signal) largest_force = std::max(largest_force, force_signal->peak());
  root_scale = {largest_x, largest_v, largest_force > 0.0 ? largest_force : 1.0};
  scale_memories();
}

void Integrator::Working::scale_memories() {
  for (size_t i = 2 * equations.masses(); i < equations.states(); ++i)
    scale[i] = equations.memory_scale(i - 2 * equations.masses(), root_scale);
}

void Integrator::Working::grow_scale() {
  for (size_t i = 0; i < 2 * equations.masses(); ++i) {
    if (!std::isfinite(y[i]))
      throw PlantError("simulation stopped at t = " + std::to_string(options.told_from_s + t) +
                       " s: the motion of mass " + std::to_string(i % equations.masses() + 1) +
                       " is no longer finite (negative damping or stiffness?)");
    scale[i] = std::max(scale[i], std::fabs(y[i]));
    double& largest = i < equations.masses() ? root_scale.displacement : root_scale.velocity;
    largest = std::max(largest, scale[i]);
  }
  scale_memories();
}

void Integrator::Working::create() {
  if (SUNContext_Create(nullptr, &context) != 0) throw PlantError("cannot create a SUNDIALS context");
  vector = N_VMake_Serial(static_cast<sunindextype>(y.size()), y.data(), context);
  use_short_loops(vector);
  arkode = ERKStepCreate(right_hand_side, t, vector, context);
  if (arkode == nullptr) throw PlantError("cannot create an ARKODE integrator");
  ERKStepSetErrHandlerFn(arkode, on_error, this);
  ERKStepSetUserData(arkode, this);
  const ARKODE_ERKTableID table = options.method == Method::kBogackiShampine3 ? ARKODE_BOGACKI_SHAMPINE_4_2_3
                                  : options.method == Method::kFehlberg8      ? ARKODE_FEHLBERG_13_7_8
                                                                              : ARKODE_DORMAND_PRINCE_7_4_5;
  check(ERKStepSetTableNum(arkode, table));
  check(ERKStepSetInterpolantDegree(arkode, 5));
  check(ERKStepWFtolerances(arkode, weights));
  check(ERKStepSetMaxNumSteps(arkode, options.most_steps_per_sample));
  if (equations.roots() > 0) check(ERKStepRootInit(arkode, static_cast<int>(equations.roots()), roots));
  ERKStepSetNoInactiveRootWarn(arkode);
}

void Integrator::Working::handle_root() {
  std::vector<int> direction(equations.roots());
  check(ERKStepGetRootInfo(arkode, direction.data()));
  excite(t);
  const std::vector<bool> resting = equations.apply_roots(direction.data(), modes);
  equations.solve_rest(t, y.data(), force.data(), base, resting, modes);
  ++events;
  restart = true;
}

Integrator::Integrator(const Equations& equations, const Excitation& excitation, const IntegratorOptions& options,
                       double start_s, double sample_period_s, std::vector<double> start_state)
    : w_(std::make_unique<Working>(equations, excitation, options)) {
  w_->t = start_s;
  w_->period = sample_period_s;
  w_->y = std::move(start_state);
  w_->dy.resize(w_->y.size());
  w_->force.assign(equations.masses(), 0.0);
  for (size_t i = 0; i < excitation.force_N.size() && i < equations.masses(); ++i)
    if (excitation.force_N[i]) w_->drive.emplace_back(excitation.force_N[i]), w_->driven.push_back(i);
  w_->excite(start_s);
  w_->modes = equations.start_modes(start_s, w_->y.data(), w_->force.data(), w_->base);
  w_->first_scale();
}

Integrator::~Integrator() = default;

void Integrator::advance_to(double t_s) {
  Working& w = *w_;
  bool by_series = w.series.has_value();
  for (long taken = 0; w.t < t_s; ++taken) {
    if (taken > w.options.most_steps_per_sample) w.fail(ARK_TOO_MUCH_WORK);
    if (by_series && (by_series = w.series_step(t_s))) continue;
    if (w.restart) {
      if (w.arkode == nullptr) w.create();
      w.check(ERKStepReset(w.arkode, w.t, w.vector));
      w.check(ERKStepSetInitStep(w.arkode, std::min(w.period, t_s - w.t)));
      w.restart = false;
    }
    w.check(ERKStepSetStopTime(w.arkode, t_s));
    const int flag = ERKStepEvolve(w.arkode, t_s, w.vector, &w.t, w.task);
    w.check(flag);
    if (flag == ARK_ROOT_RETURN) w.handle_root();
  }
  w.grow_scale();
  w.excite(w.t);
  if (w.equations.roots() == 0) return;
  if (w.equations.resync(w.y.data(), w.force.data(), w.base, w.modes)) w.restart = true;
  w.equations.equalise(w.y.data(), w.base, w.modes);
}

double Integrator::time_s() const { return w_->t; }
const std::vector<double>& Integrator::state() const { return w_->y; }
const std::vector<double>& Integrator::forces() const { return w_->force; }
const Motion& Integrator::base() const { return w_->base; }
const Modes& Integrator::modes() const { return w_->modes; }
long Integrator::events() const { return w_->events; }
long Integrator::steps() const {
  long count = 0;
  if (w_->arkode != nullptr) ERKStepGetNumSteps(w_->arkode, &count);
  return count;
}

const std::vector<double>& Integrator::derivative() const {
  w_->equations.derivative(w_->t, w_->y.data(), w_->force.data(), w_->base, w_->modes, w_->dy.data());
  return w_->dy;
}

}  // namespace host_sim
