// Why a simulation could not go on, in the words of who wrote the rig file.
#include <algorithm>
#include <cmath>

#include "host_sim/plant/motion/integrator_working.hpp"

namespace host_sim {
namespace {

std::string reason_of(int flag, long most_steps) {
  switch (flag) {
    case ARK_TOO_MUCH_WORK:
      return "one sample takes more than " + std::to_string(most_steps) + " steps (a rig with extreme stiffness?)";
    case ARK_TOO_MUCH_ACC:
      return "within one sample the motion grows far beyond all that it was before (negative damping or stiffness?)";
    case ARK_ERR_FAILURE:
    case ARK_CONV_FAILURE:
    case ARK_TOO_CLOSE:
      return "no step is short enough for the tolerance (a rig with extreme stiffness, or a motion that grows without "
             "bound?)";
    default:
      return "no step can be taken from there (flag " + std::to_string(flag) + " of the solver)";
  }
}

}  // namespace

void Integrator::Working::fail(int flag) const {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  const bool lost = !std::all_of(y.begin(), y.end(), is_finite);
  throw PlantError("simulation stopped at t = " + std::to_string(options.told_from_s + t) + " s: " +
                   (lost ? "the motion is no longer finite (negative damping or stiffness?)"
                         : reason_of(flag, options.most_steps_per_sample)));
}

}  // namespace host_sim
