#include "firmware/identification/intervals/bias_check.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

void add_moment(PackedScaled& place, const Scaled& moment) { place = place + pack(moment); }

// Each batch's change of the right-hand sides, times the columns of its rows.
void add_equation(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                  WeightedFit& fit, BiasCheck& check) {
  if (whitening.deviation.is_zero()) return;
  const ReducedRows& rows = fit.reduce(whitening, e, false);
  const WholeColumn change = rows.residual();
  const Scaled weight = whitening.weight();
  Row row;
  if (level.periodic() && !whitened_level_row(list, level, whitening, e, row)) return;
  for (int b = 0; b < level.batch_count(); ++b) {
    if (change.value[b] == 0) continue;
    if (level.periodic()) {
      const Scaled whitened = Scaled::from_int(change.value[b], change.exponent) / whitening.deviation;
      for (int k = 0; k < list.unknown_count; ++k) add_moment(check.moment[b][k], row.column[k] * whitened);
      continue;
    }
    for (int j = 0; j < rows.unknowns; ++j) {
      const int64_t product = static_cast<int64_t>(rows.value[j][b]) * change.value[b];
      add_moment(check.moment[b][rows.unknown[j]],
                 Scaled::from_int(product, rows.exponent[j] + change.exponent) * weight);
    }
  }
}

// Sum over the batches of what each shifts the parameters by, and its variance by their scatter.
void add_level(const EquationList& list, WeightedFit& fit, int batches, BiasCheck& check) {
  Scaled moment[kMaxUnknowns], shift[kMaxUnknowns], sum[kMaxUnknowns];
  Scaled* const squares = fit.vector();
  for (int k = 0; k < list.unknown_count; ++k) squares[k] = Scaled{};
  for (int b = 0; b < batches; ++b) {
    for (int k = 0; k < list.unknown_count; ++k) moment[k] = unpack(check.moment[b][k]);
    fit.equations().apply_covariance(moment, shift);
    for (int k = 0; k < list.unknown_count; ++k) {
      sum[k] += shift[k];
      multiply_add(squares[k], shift[k], shift[k]);
    }
  }
  for (int k = 0; k < list.unknown_count; ++k) {
    check.difference[k] += sum[k];
    const Scaled of_mean = sum[k] * sum[k] / batches;
    check.deviation[k] += batches > 1 ? (squares[k] - of_mean) * Scaled::ratio(batches, batches - 1) : of_mean;
  }
}

}  // namespace

void begin_comparison(BiasCheck& result) {
  for (int k = 0; k < kMaxUnknowns; ++k) result.difference[k] = result.deviation[k] = Scaled{};
}

void compare_with_plain(const EquationList& list, LevelColumns& level, int l, WeightedFit& fit, BiasCheck& result) {
  const int batches = level.batch_count();
  if (!list.instrument || batches == 0) return;
  // What the residual of a velocity equation changes by where it is weighted with the plain velocity.
  level.load_changes([&](const Batch& batch, int e) {
    if (e >= list.dof_count) return Scaled{};
    const Equation plain = {list.equation[e].dof, Weight::kPlain};
    return batch_residual(fit.layout(), batch, plain, fit.parameters()) -
           batch_residual(fit.layout(), batch, list.equation[e], fit.parameters());
  });
  for (int b = 0; b < batches; ++b, report_work(40 + 40 * list.unknown_count))
    for (int k = 0; k < list.unknown_count; ++k) result.moment[b][k] = PackedScaled{};
  for (int e = 0; e < list.count; ++e) add_equation(list, level, fit.whitening(l, e), e, fit, result);
  add_level(list, fit, batches, result);
}

void end_comparison(const EquationList& list, BiasCheck& result) {
  for (int k = 0; k < list.unknown_count; ++k) result.deviation[k] = sqrt(result.deviation[k]);
}

bool bias_suspect(const BiasCheck& check, int unknown, const ParameterEstimate& parameter) {
  const Scaled difference = abs(check.difference[unknown]);
  return difference > check.deviation[unknown] * 3 &&
         scale_by_power_of_two(difference, 1) > parameter.ci95_high - parameter.ci95_low &&
         exceeds(difference * 20, parameter.value);
}

}  // namespace firmware
