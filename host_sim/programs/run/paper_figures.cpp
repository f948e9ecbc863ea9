#include "host_sim/programs/run/paper_figures.hpp"

#include <map>

namespace host_sim {
namespace {

struct Figures {
  std::map<std::string, double> estimates;
  double residual;  // mean normalised residual of Eq. 20
  std::vector<double> mse_percent;
};

std::map<std::string, double> two_dof(double c1, double c2, double f1, double f2) {
  return {{"viscous[1-2]", c1}, {"viscous[2-0]", c2}, {"coulomb[1-2]", f1}, {"coulomb[2-0]", f2}};
}
std::map<std::string, double> three_dof(double c11, double c12, double c23, double c33, double f) {
  return {
      {"viscous[1-0]", c11}, {"viscous[1-2]", c12}, {"viscous[2-3]", c23}, {"viscous[3-0]", c33}, {"coulomb[3-0]", f}};
}

// Sections 3.1 and 3.2 of the paper.
const std::map<std::string, Figures>& paper() {
  static const std::map<std::string, Figures> figures = {
      {"paper_2dof", {two_dof(5.9993, 6.0089, 9.9422, 9.9462), 1.11e-3, {1.67e-6, 1.32e-5}}},
      {"paper_2dof_noise", {two_dof(5.84, 5.96, 13.73, 10.29), 1.75e-2, {0.0011, 0.132}}},
      {"paper_3dof_two_frequencies", {three_dof(20.04, 20.05, 20.19, 20.09, 1.01), 7.94e-4, {0.0012, 0.0013, 0.0013}}},
      {"paper_3dof_one_frequency", {three_dof(19.26, 18.16, 23.41, 20.80, 1.015), 9.49e-5, {0.0038, 0.0014, 0.0029}}},
      {"paper_3dof_two_frequencies_noise",
       {three_dof(19.70, 17.25, 18.45, 20.08, 0.85), 3.57e-2, {0.029, 0.032, 0.035}}},
      {"paper_3dof_random", {three_dof(20.0002, 20.0010, 19.9990, 20.0036, 0.999995), 9.37e-6, {0.029, 0.047, 0.091}}},
      {"paper_3dof_random_noise",
       {three_dof(19.9986, 20.0010, 19.9990, 20.0004, 0.99995), 2.32e-6, {0.037, 0.074, 0.107}}},
  };
  return figures;
}

}  // namespace

void add_paper_figures(const std::string& scenario_name, EstimateResult& result) {
  const auto found = paper().find(scenario_name);
  if (found == paper().end()) return;
  for (ParameterResult& parameter : result.parameters) {
    const auto estimate = found->second.estimates.find(parameter.info.name);
    if (estimate != found->second.estimates.end()) parameter.paper = estimate->second;
  }
  result.paper_residual = found->second.residual;
  result.paper_mse_percent = found->second.mse_percent;
}

}  // namespace host_sim
