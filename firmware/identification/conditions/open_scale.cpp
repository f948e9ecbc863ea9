#include "firmware/identification/conditions/open_scale.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

bool acts_on(const CoreConfiguration& configuration, const Term& term, int dof) {
  if (term.kind == TermKind::kMass) return term.place == dof;
  const LinkConfiguration& link = configuration.links[term.place];
  return link.node_a == dof || link.node_b == dof;
}

// Nothing that is known acts on the DOF, and its mass was asked for and not found.
bool scale_is_open(const CoreConfiguration& configuration, const Estimates& estimates, int dof) {
  if (configuration.channels[dof][static_cast<int>(Quantity::kForce)].present) return false;
  bool open = false;
  report_work(15 * configuration.term_count);
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (!acts_on(configuration, term, dof)) continue;
    if (term.unknown < 0) return false;
    if (term.kind == TermKind::kMass)
      open = estimates.parameters[term.unknown].status == EstimateStatus::kIllConditioned;
  }
  return open;
}

void doubt(const CoreConfiguration& configuration, int dof, Estimates& estimates) {
  report_work(15 * configuration.term_count);
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.unknown < 0 || !acts_on(configuration, term, dof)) continue;
    EstimateStatus& status = estimates.parameters[term.unknown].status;
    if (status == EstimateStatus::kValid) status = EstimateStatus::kBiasSuspect;
  }
}

}  // namespace

void doubt_beside_open_scale(const CoreConfiguration& configuration, const EquationList& list, Estimates& estimates) {
  for (int dof = 0; dof < list.dof_count; ++dof) {
    if (!scale_is_open(configuration, estimates, dof)) continue;
    for (int other = 0; other < list.dof_count; ++other)
      if ((list.neighbours[dof] >> other & 1) != 0) doubt(configuration, other, estimates);
  }
}

}  // namespace firmware
