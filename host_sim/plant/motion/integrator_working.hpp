// What an Integrator works with; inside the integrator only.
#pragma once
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <limits>
#include <optional>
#include <vector>

#include "host_sim/plant/motion/integrator.hpp"
#include "host_sim/plant/motion/taylor_step.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {

struct Integrator::Working {
  static constexpr double kLoose = 1e-8;
  const Equations& equations;
  const Excitation& excitation;
  IntegratorOptions options;
  double t = 0.0, period = 0.0;
  std::vector<double> y, dy, scale, force;
  std::vector<SignalReader> drive;  // of the DOFs that have a force
  std::vector<size_t> driven;       // which
  MotionScale root_scale;
  Motion base;
  Modes modes;
  long steps = 0, events = 0;
  bool restart = true;
  int task = ARK_NORMAL;
  std::optional<TaylorStep> series;
  std::vector<double> ahead, reserve;  // of the series: a later state, and its root functions
  double last_event_s = -std::numeric_limits<double>::infinity();
  SUNContext context = nullptr;
  N_Vector vector = nullptr;
  void* arkode = nullptr;

  Working(const Equations& eq, const Excitation& ex, const IntegratorOptions& opt)
      : equations(eq), excitation(ex), options(opt) {
    if (options.method == Method::kSeries && eq.linear_between_events()) series.emplace(eq, ex);
    // ARKODE interpolates where a call begins, and in one go where it ends too: step by step is less where most samples take
    // one step. The state is the same: that of the stop time.
    if (options.relative_tolerance >= kLoose) task = ARK_ONE_STEP;
  }
  ~Working() {
    if (arkode != nullptr) ERKStepFree(&arkode);
    if (vector != nullptr) N_VDestroy(vector);
    if (context != nullptr) SUNContext_Free(&context);
  }

  void excite(double time_s) {
    for (size_t k = 0; k < drive.size(); ++k) force[driven[k]] = drive[k].value(time_s);
    if (excitation.base_m) base = excitation.base_m->motion(time_s);
  }

  static int right_hand_side(realtype time_s, N_Vector state, N_Vector derivative, void* user) {
    Working& w = *static_cast<Working*>(user);
    w.excite(time_s);
    w.equations.derivative(time_s, N_VGetArrayPointer(state), w.force.data(), w.base, w.modes,
                           N_VGetArrayPointer(derivative));
    return 0;
  }
  static int roots(realtype time_s, N_Vector state, realtype* g, void* user) {
    Working& w = *static_cast<Working*>(user);
    w.excite(time_s);
    w.equations.root_functions(time_s, N_VGetArrayPointer(state), w.force.data(), w.base, w.modes, w.root_scale, g);
    return 0;
  }
  static int weights(N_Vector, N_Vector weight, void* user) {
    const Working& w = *static_cast<Working*>(user);
    realtype* target = N_VGetArrayPointer(weight);
    for (size_t i = 0; i < w.scale.size(); ++i) target[i] = 1.0 / (w.options.relative_tolerance * w.scale[i]);
    return 0;
  }
  // The solver's own words name its functions: integrator_failure.cpp says what the flag means.
  static void on_error(int, const char*, const char*, char*, void*) {}

  // integrator_series.cpp: one step towards t_s by the Taylor series, up to the first event at the latest. False: not from
  // here; ARKODE takes the rest of the sample.
  bool series_step(double t_s);

  double nearest_event(double step_s, double theta);
  double event_between(double step_s, double begin, double end);
  void series_event(double step_s, double theta);

  void create();
  void first_scale();
  void grow_scale();
  void scale_memories();
  void handle_root();
  void check(int flag) const {
    if (flag < 0) fail(flag);
  }
  [[noreturn]] void fail(int flag) const;
};

}  // namespace host_sim
