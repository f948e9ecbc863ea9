#include "firmware/identification/whitening.hpp"

namespace firmware {
namespace {

constexpr int kSize = kMaxPredecessors + 1;

// The observables that equation e is reduced by, own ones first; at most limit.
int list_predecessors(const EquationList& list, const LevelObservables& level, int e, int limit, uint8_t* observable) {
  const Equation& equation = list.equation[e];
  int count = 0;
  const auto add = [&](int index) {
    if (count < limit) observable[count++] = static_cast<uint8_t>(index);
  };
  const auto add_controls = [&](int dof) {
    for (int which = 0; which < kControlsPerDof; ++which) {
      const int c = LevelObservables::control(dof, which);
      if ((which < 2 || list.displacement) && level.control_valid(c)) add(c);
    }
  };
  add_controls(equation.dof);
  for (int before = 0; before < e; ++before)
    if ((list.neighbours[equation.dof] >> list.equation[before].dof & 1u) && level.scatters(before))
      add(LevelObservables::equation(before));
  for (int j = 0; j < list.dof_count; ++j)
    if (j != equation.dof && (list.neighbours[equation.dof] >> j & 1u)) add_controls(j);
  return count;
}

// Sums of products of the observables (the last one is the equation itself), as of the level's total for periodic
// levels.
void gram(const LevelObservables& level, const uint8_t* observable, int size, Scaled (*sums)[kSize]) {
  for (int r = 0; r < size; ++r)
    for (int c = 0; c <= r; ++c) {
      Scaled sum;
      for (int b = 0; b < level.batch_count(); ++b)
        sum = sum + level.deviation(observable[r], b) * level.deviation(observable[c], b);
      if (r == c && observable[r] < kMaxControls) sum = sum + level.end_variance(observable[r]);
      sums[r][c] = sum;
    }
}

// Cholesky in place, leaving out observables that the ones before already determine; then the coefficients of the last
// row. Returns what is left of the last observable's sum of squares.
Scaled regress(Scaled (*sums)[kSize], int predecessors, Scaled* coefficient) {
  bool kept[kSize];
  for (int r = 0; r <= predecessors; ++r) {
    const Scaled own = sums[r][r];
    for (int c = 0; c <= r; ++c) {
      Scaled sum = sums[r][c];
      for (int k = 0; k < c; ++k)
        if (kept[k]) sum = sum - sums[r][k] * sums[c][k];
      if (c < r) {
        sums[r][c] = kept[c] ? sum / sums[c][c] : Scaled{};
      } else if (r < predecessors) {
        kept[r] = sum > scale_by_power_of_two(own, -30);
        sums[r][r] = sqrt(sum);
      } else {
        sums[r][r] = sum;
      }
    }
  }
  for (int k = predecessors - 1; k >= 0; --k) {
    coefficient[k] = Scaled{};
    if (!kept[k]) continue;
    Scaled sum = sums[predecessors][k];
    for (int j = k + 1; j < predecessors; ++j) sum = sum - sums[j][k] * coefficient[j];
    coefficient[k] = sum / sums[k][k];
  }
  return sums[predecessors][predecessors];
}

}  // namespace

Whitening measure_whitening(const EquationList& list, const LevelObservables& level, int e) {
  Whitening result;
  const int dof = list.equation[e].dof, rows = level.rows_used(dof);
  result.inflation = Scaled::from_int(1);
  if (rows < kLeastBatches) return result;
  int limit = (rows - 1) / kBatchesPerCoefficient;
  if (limit > kMaxPredecessors) limit = kMaxPredecessors;
  uint8_t observable[kSize] = {};
  result.count = static_cast<uint8_t>(list_predecessors(list, level, e, limit, observable));
  observable[result.count] = static_cast<uint8_t>(LevelObservables::equation(e));
  Scaled sums[kSize][kSize];
  gram(level, observable, result.count + 1, sums);
  const Scaled unreduced = sums[result.count][result.count];
  const Scaled energy = level.energy_square(e);
  // The energies of repeated batches add up, their noise only in squares.
  if (!energy.is_zero())
    result.relative_noise_square = unreduced / energy / Scaled::from_int(level.periodic() ? rows : 1);
  Scaled left = regress(sums, result.count, result.coefficient);
  if (left < level.rounding_square(e)) left = level.rounding_square(e);
  if (left.is_zero()) return result;
  for (int j = 0; j < result.count; ++j) result.observable[j] = observable[j];
  const int freedom = rows - result.count - (level.periodic() ? 1 : 0);
  const Scaled repeats = Scaled::from_int(level.periodic() ? rows : 1);
  result.deviation = sqrt(repeats * left / Scaled::from_int(freedom));
  result.freedom = static_cast<int16_t>(freedom);
  if (freedom > 2) result.inflation = Scaled::ratio(rows - 2, rows - result.count - 2);
  result.measured = true;
  return result;
}

bool whitened_row(const EquationList& list, const LevelObservables& level, const Whitening& whitening, int e, int batch,
                  Row& row) {
  if (whitening.deviation.is_zero() || (batch >= 0 && !level.row_used(batch, list.equation[e].dof))) return false;
  const auto read = [&](int equation, Row& target) {
    if (batch < 0) {
      level.level_row(equation, target);
    } else {
      level.row(equation, batch, target);
    }
  };
  read(e, row);
  for (int j = 0; j < whitening.count; ++j) {
    const int observable = whitening.observable[j];
    const Scaled factor = whitening.coefficient[j];
    if (observable < kMaxControls) {
      row.rhs = row.rhs - factor * (batch < 0 ? level.total(observable) : level.deviation(observable, batch));
      continue;
    }
    Row other;
    read(observable - kMaxControls, other);
    row.rhs = row.rhs - factor * other.rhs;
    for (int k = 0; k < list.unknown_count; ++k) row.column[k] = row.column[k] - factor * other.column[k];
  }
  for (int k = 0; k < list.unknown_count; ++k) row.column[k] = row.column[k] / whitening.deviation;
  row.rhs = row.rhs / whitening.deviation;
  return true;
}

}  // namespace firmware
