// Advances the equations of a rig in time, stopping at every event to change the modes: by its Taylor series where the rig is
// linear between events, else with SUNDIALS ARKODE (ERKStep).
#pragma once
#include <memory>
#include <vector>

#include "host_sim/plant/motion/equations.hpp"

namespace host_sim {

enum class Method {
  kSeries,  // the Taylor series between events where the rig is linear there (taylor_step.hpp), elsewhere kDormandPrince5
  kFehlberg8,         // 13 stages, order 8 (7): for tolerances below 1e-11
  kDormandPrince5,    // 7 stages, order 5 (4)
  kBogackiShampine3,  // 4 stages, order 3 (2): the pair that the paper cites [17]
};

struct IntegratorOptions {
  Method method = Method::kSeries;
  double relative_tolerance =
      1e-10;  // local error per step, of the largest displacement and velocity of each mass so far
  long most_steps_per_sample = 200000;
  double told_from_s = 0.0;  // what messages add to the time: where a record begins in its file
};

class Integrator {
 public:
  // sample_period_s: the usual distance between calls of advance_to; the first step tries it.
  Integrator(const Equations& equations, const Excitation& excitation, const IntegratorOptions& options, double start_s,
             double sample_period_s, std::vector<double> start_state);
  ~Integrator();
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  // Throws PlantError where the step size collapses or the motion is no longer finite.
  void advance_to(double t_s);

  double time_s() const;
  const std::vector<double>& state() const;       // stuck links: ends move exactly alike
  const std::vector<double>& derivative() const;  // at the present time and modes: accelerations at [masses() + i]
  const std::vector<double>& forces() const;      // per mass, at the present time
  const Motion& base() const;
  const Modes& modes() const;
  long steps() const;  // taken by ARKODE so far
  long events() const;

 private:
  struct Working;
  std::unique_ptr<Working> w_;
};

}  // namespace host_sim
