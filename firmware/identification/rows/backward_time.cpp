#include "firmware/identification/rows/backward_time.hpp"

namespace firmware {
namespace {

// A bit per kind, taken from the vocabulary when compiling: the table's words stay out of the image.
constexpr uint32_t turning_terms() {
  uint32_t bits = 0;
  for (int t = 0; t < kTermKinds; ++t)
    if (row_of(static_cast<TermKind>(t)).nature.turns_with_time()) bits |= uint32_t{1} << t;
  return bits;
}
constexpr uint32_t turning_causes() {
  uint32_t bits = 0;
  for (const EffectRow& row : kEffectTable)
    if (row.can.number < 32 && row.nature.turns_with_time()) bits |= uint32_t{1} << row.can.number;
  return bits;
}
constexpr uint32_t kTurningTerms = turning_terms(), kTurningCauses = turning_causes();

bool turns(Cause cause) {
  const auto number = static_cast<unsigned>(cause);
  return number < 32 && (kTurningCauses >> number & 1) != 0;
}

void turn(ParameterEstimate& parameter) {
  parameter.value = -parameter.value;
  parameter.plain_value = -parameter.plain_value;
  const Scaled low = -parameter.ci95_high;
  parameter.ci95_high = -parameter.ci95_low;
  parameter.ci95_low = low;
}

void turn(Finding& finding) {
  if (turns(finding.cause)) finding.size = -finding.size;
}

}  // namespace

bool turns_over(TermKind kind) { return (kTurningTerms >> static_cast<int>(kind) & 1) != 0; }

bool turns_over(const CoreConfiguration& configuration, int unknown) {
  if (!configuration.runs_back()) return false;
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return turns_over(configuration.terms[t].kind);
  return false;
}

void run_forward(const CoreConfiguration& configuration, Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (turns_over(configuration, k)) turn(estimates.parameters[k]);
  turn(estimates.warrant.named);
  turn(estimates.warrant.rival);
  for (int dof = 0; dof < configuration.dof_count; ++dof) {
    estimates.displacement_skew[dof].late_s = -estimates.displacement_skew[dof].late_s;
    estimates.acceleration_skew[dof].late_s = -estimates.acceleration_skew[dof].late_s;
  }
}

}  // namespace firmware
