#include "firmware/identification/fit/whitening.hpp"

namespace firmware {
namespace {

constexpr int kSize = kMaxPredecessors + 1;
constexpr int kMostSummands = kMaxUnknowns > kSize ? kMaxUnknowns : kSize;

// The observables that equation e is reduced by, own ones first; at most limit.
int list_predecessors(const EquationList& list, const LevelColumns& level, int e, int limit, uint8_t* observable) {
  const Equation& equation = list.equation[e];
  int count = 0;
  const auto add = [&](int index) {
    if (count < limit) observable[count++] = static_cast<uint8_t>(index);
  };
  const auto add_controls = [&](int dof) {
    for (int which = 0; which < kControlsPerDof; ++which) {
      const int c = LevelColumns::control(dof, which);
      if ((which < 2 || (kHasDisplacementRows && list.displacement)) && list.shows_noise(dof, which) &&
          level.control_valid(c))
        add(c);
    }
  };
  add_controls(equation.dof);
  for (int before = 0; before < e; ++before)
    if ((list.neighbours[equation.dof] >> list.equation[before].dof & 1u) && level.scatters(before))
      add(LevelColumns::residual(before));
  for (int j = 0; j < list.dof_count; ++j)
    if (j != equation.dof && (list.neighbours[equation.dof] >> j & 1u)) add_controls(j);
  return count;
}

// Sums of products of the observables (the last one is the equation itself), as of the level's total for periodic
// levels.
void gram(const LevelColumns& level, const uint8_t* observable, int size, Scaled (*sums)[kSize]) {
  for (int r = 0; r < size; ++r)
    for (int c = 0; c <= r; ++c) {
      sums[r][c] = level.product(observable[r], observable[c]);
      if (kReduces && r == c && observable[r] < kMaxControls) sums[r][c] += level.end_variance(observable[r]);
    }
}

// Cholesky in place, leaving out observables that the ones before already determine; then the coefficients of the last
// row. Returns what is left of the last observable's sum of squares.
Scaled regress(Scaled (*sums)[kSize], int predecessors, Scaled* coefficient) {
  bool kept[kSize];
  for (int r = 0; r <= predecessors; ++r) {
    Scaled* const row = sums[r];
    const Scaled least = r < predecessors ? scale_by_power_of_two(row[r], -30) : Scaled{};
    for (int c = 0; c <= r; ++c) {
      for (int k = 0; k < c; ++k)
        if (kept[k]) multiply_subtract(row[c], row[k], sums[c][k]);
      if (c == r) break;
      if (kept[c])
        row[c] /= sums[c][c];
      else
        row[c] = Scaled{};
    }
    if (r == predecessors) break;
    kept[r] = row[r] > least;
    row[r] = sqrt(row[r]);
  }
  const Scaled* const last = sums[predecessors];
  for (int k = predecessors - 1; k >= 0; --k) {
    coefficient[k] = Scaled{};
    if (!kept[k]) continue;  // NOLINT(clang-analyzer-core.uninitialized.Branch): written above for every row
    coefficient[k] = last[k];
    for (int j = k + 1; j < predecessors; ++j) multiply_subtract(coefficient[k], sums[j][k], coefficient[j]);
    coefficient[k] /= sums[k][k];
  }
  return last[predecessors];
}

}  // namespace

Scaled Whitening::weight() const { return kScaledOne / (deviation * deviation); }

Whitening measure_whitening(const EquationList& list, const LevelColumns& level, int e, Scaled& relative_noise_square) {
  Whitening result;
  const int rows = level.rows_used(e);
  result.inflation = kScaledOne;
  // Rows that differ are fitted by the equation's own unknowns: what is left of so few more is no scatter.
  const int fitted = level.periodic() ? 0 : level.behind_terms(e) - level.first_term(e);
  if (rows < kLeastBatches + fitted) return result;
  int limit = (rows - 1) / kBatchesPerCoefficient;
  if (limit > kMaxPredecessors) limit = kMaxPredecessors;
  uint8_t observable[kSize] = {};
  if (kReduces) result.count = static_cast<uint8_t>(list_predecessors(list, level, e, limit, observable));
  const int count = result.coefficients();
  observable[count] = static_cast<uint8_t>(LevelColumns::residual(e));
  Scaled sums[kSize][kSize];
  gram(level, observable, count + 1, sums);
  const Scaled& unreduced = sums[count][count];
  const Scaled energy = level.energy_square(e);
  // The energies of repeated batches add up, their noise only in squares.
  if (!energy.is_zero()) relative_noise_square = unreduced / energy / (level.periodic() ? rows : 1);
  Scaled left = regress(sums, count, result.coefficient);
  keep_larger(left, level.rounding_square(e));
  if (left.is_zero()) return result;
  for (int j = 0; j < count; ++j) result.observable[j] = observable[j];
  const int freedom = rows - count - (level.periodic() ? 1 : 0);
  const Scaled repeats = Scaled::from_int(level.periodic() ? rows : 1);
  result.deviation = sqrt(repeats * left / freedom);
  result.freedom = static_cast<int16_t>(freedom);
  if (freedom > 2) result.inflation = Scaled::ratio(rows - 2, rows - count - 2);
  result.measured = true;
  return result;
}

namespace {

// One term of a sum of columns.
struct Summand {
  WholeColumn column;
  Scaled factor;
};

// target = sum of factor * column, rounded to a column whose exponent leaves room for the largest that the sum can be.
// |column| <= 2^kColumnBits, factors as whole numbers below 2^30: products below 2^60.
int32_t sum_columns(const Summand* summand, int count, int batches, int32_t* target) {
  int32_t top = 0;
  bool any = false;
  for (int s = 0; s < count; ++s) {
    if (summand[s].factor.is_zero()) continue;
    const int32_t size = log2_floor(summand[s].factor) + 1 + summand[s].column.exponent;
    if (!any || size > top) top = size;
    any = true;
  }
  int32_t factor[kMostSummands];
  const int32_t* column[kMostSummands];
  const int32_t exponent = top + bits_of(count);
  for (int s = 0; s < count; ++s) {
    const Scaled share = scale_by_power_of_two(summand[s].factor, summand[s].column.exponent - exponent);
    factor[s] = static_cast<int32_t>(to_fixed(share, kColumnFactorBits));
    column[s] = summand[s].column.value;
  }
  add_columns(column, factor, count, batches, target);
  return exponent;
}

void add_unknowns(const LevelColumns& level, int e, ReducedRows& reduced) {
  for (int n = level.first_term(e); n < level.behind_terms(e); ++n) {
    int k = 0;
    while (k < reduced.unknowns && reduced.unknown[k] != level.unknown_of(n)) ++k;
    if (k == reduced.unknowns) reduced.unknown[reduced.unknowns++] = static_cast<uint8_t>(level.unknown_of(n));
  }
}

// The columns of one unknown in an equation: at most one.
int add_summand(const LevelColumns& level, int e, int unknown, const Scaled& factor, Summand* summand, int count) {
  for (int n = level.first_term(e); n < level.behind_terms(e); ++n)
    if (level.unknown_of(n) == unknown) summand[count++] = {level.column(level.term(e, n)), factor};
  return count;
}

}  // namespace

void ReducedRows::read(int batch, int unknown_count, Row& row) const {
  clear_row(unknown_count, row);
  for (int k = 0; k < unknowns; ++k) row.column[unknown[k]] = Scaled::from_int(value[k][batch], exponent[k]);
  row.rhs = Scaled::from_int(value[unknowns][batch], exponent[unknowns]);
}

WholeColumn ReducedRows::combine(const Scaled* factor, int count) {
  Summand summand[kMaxUnknowns];
  for (int k = 0; k < unknowns; ++k) summand[k] = {column(k), factor[k]};
  exponent[unknowns + 1] = sum_columns(summand, unknowns, count, value[unknowns + 1]);
  return column(unknowns + 1);
}

void reduce_rows(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                 bool with_controls, ReducedRows& reduced) {
  const int batches = level.batch_count(), dof = list.equation[e].dof;
  Summand summand[kMaxPredecessors + 1];
  reduced.unknowns = 0;
  add_unknowns(level, e, reduced);
  for (int j = 0; j < whitening.coefficients(); ++j)
    if (whitening.observable[j] >= kMaxControls) add_unknowns(level, whitening.observable[j] - kMaxControls, reduced);
  for (int k = 0; k < reduced.unknowns; ++k) {
    int count = add_summand(level, e, reduced.unknown[k], kScaledOne, summand, 0);
    for (int j = 0; j < whitening.coefficients(); ++j)
      if (whitening.observable[j] >= kMaxControls)
        count = add_summand(level, whitening.observable[j] - kMaxControls, reduced.unknown[k],
                            -whitening.coefficient[j], summand, count);
    reduced.exponent[k] = sum_columns(summand, count, batches, reduced.value[k]);
  }
  int count = 0;
  summand[count++] = {level.column(LevelColumns::residual(e)), kScaledOne};
  for (int j = 0; j < whitening.coefficients(); ++j)
    if (with_controls || whitening.observable[j] >= kMaxControls)
      summand[count++] = {level.column(whitening.observable[j]), -whitening.coefficient[j]};
  reduced.exponent[reduced.unknowns] = sum_columns(summand, count, batches, reduced.value[reduced.unknowns]);
  reduced.rows = level.rows_used(e);
  for (int b = 0; b < batches; ++b) {
    if (level.row_used(b, dof)) continue;
    for (int k = 0; k <= reduced.unknowns; ++k) reduced.value[k][b] = 0;
  }
}

bool whitened_level_row(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                        Row& row) {
  if (whitening.deviation.is_zero() || level.batch_count() == 0) return false;
  level.level_row(e, row);
  for (int j = 0; j < whitening.coefficients(); ++j) {
    const int observable = whitening.observable[j];
    const Scaled factor = whitening.coefficient[j];
    multiply_subtract(row.rhs, factor, level.total(observable));
    if (observable < kMaxControls) continue;
    Row other;
    level.level_row(observable - kMaxControls, other);
    for (int k = 0; k < list.unknown_count; ++k) multiply_subtract(row.column[k], factor, other.column[k]);
  }
  for (int k = 0; k < list.unknown_count; ++k) row.column[k] /= whitening.deviation;
  row.rhs /= whitening.deviation;
  return true;
}

}  // namespace firmware
