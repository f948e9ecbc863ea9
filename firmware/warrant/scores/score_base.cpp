// The scores of the estimated terms: weights of the places, the normal matrix and its inverse.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {
namespace {

constexpr int kLeastForWeights = 8;  // stretches of a level that show its own scatter

}  // namespace

// From the scores of the place's rate (on a DOF, of its acceleration).
void ScoreTest::weigh(int number) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[number];
  const Form wanted = place.kind == PlaceKind::kDof ? Form::kAcceleration : Form::kRate;
  int found = -1;
  for (int j = plan.summed_count - 1; j >= 0; --j)
    if (plan.probe[j].place == number && (found < 0 || plan.probe[j].form == wanted)) found = j;
  if (found < 0) return;
  open(plan.probe[found]);
  for (int e = 0; e < place.equations; ++e) {
    Scaled one[kPlaceEquations];
    one[e] = kScaledOne;
    score_sum_.clear();
    add_scores(score_sum_, one);
    report_work(300 * stretches_);
    score_sum_.of_all(sums_->table(), 0, stretches_, e == 0 ? psi_ : d_);
  }
  for (int level = 0; level < levels_; ++level) weigh_level(place, level, number);
}

void ScoreTest::weigh_level(const Place& place, int level, int number) {
  Scaled square[kPlaceEquations], both;  // covariance of the equations' residuals
  int from = level_begin_[level], to = level_begin_[level + 1];
  if (to - from < kLeastForWeights) from = 0, to = stretches_;  // all levels where one alone is too short
  const int own_value = sums_->plan().own_value(*probe_);
  Scaled own;
  for (int s = from; s < to; ++s, report_work(100)) {
    own += abs(sums_->table().value(s, own_value));
    multiply_add(square[0], psi_[s], psi_[s]);
    if (place.equations == 1) continue;
    multiply_add(both, psi_[s], d_[s]);
    multiply_add(square[1], d_[s], d_[s]);
  }
  own *= unit_[own_value - probe_->first_value];
  for (Scaled& one : square) one += scale_by_power_of_two(one, -6);
  Scaled* g = weight_[number][level];
  const bool apart = place.equations == 1 || both.is_zero() || square[0].is_zero() || square[1].is_zero();
  Scaled scale;
  if (!apart) scale = own / (square[0] * square[1] - both * both);
  for (int e = 0; e < place.equations; ++e, ++g) {
    *g = Scaled{};
    if (apart) {
      add_signed(*g, place.sign[e], square[e].is_zero() ? kScaledOne : own / square[e]);
      continue;
    }
    add_signed(*g, place.sign[e], square[1 - e]);
    add_signed(*g, -place.sign[1 - e], both);
    *g *= scale;
  }
}

void ScoreTest::add_base(const Probe& probe) {
  const int row = probe.unknown;
  place_of_unknown_[row] = probe.place;
  determined_[row] = true;
  open(probe);
  for (int level = 0; level < levels_; ++level) {
    take_level(level);
    score_sum_.clear();
    add_scores(score_sum_, weight_[probe.place][level]);
    for (int s = level_begin_[level]; s < level_begin_[level + 1]; ++s, report_work(350))
      base_score_[s][row] = short_scaled(score_sum_.of(sums_->table(), s));
    for (int k = 0; k < place_->columns; ++k) {
      Scaled& entry = normal_[row][place_->unknown[k]];
      if (!column_weight_[k].is_zero()) multiply_add(entry, column_weight_[k], column_total(level, k));
    }
  }
  base_doubt_[row] = doubtful_score();
}

namespace {

void scale_row(Scaled* row, int size, const Scaled& by) {
  for (int j = 0; j < size; ++j) row[j] *= by;
}
void take_off(Scaled* row, int size, const Scaled& factor, const Scaled* other) {
  for (int j = 0; j < size; ++j) multiply_subtract(row[j], factor, other[j]);
}

}  // namespace

// Gauss-Jordan with the largest pivot of what is left, rows and columns scaled; a term that is a combination of others is
// left out (it keeps the estimator's value).
void ScoreTest::invert() {
  const int n = unknowns_;
  Scaled scale[kMaxUnknowns];
  bool done[kMaxUnknowns] = {};
  for (int i = 0; i < n; ++i) {
    scale[i] = sqrt(abs(normal_[i][i]));
    if (scale[i].is_zero()) determined_[i] = false;
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      Scaled& entry = normal_[i][j];
      if (determined_[i] && determined_[j])
        entry /= scale[i] * scale[j];
      else
        entry = Scaled{};
      inverse_[i][j] = determined_[i] && i == j ? kScaledOne : Scaled{};
    }
  for (int turn = 0; turn < n; ++turn) {
    int pivot = -1;
    for (int i = 0; i < n; ++i)
      if (!done[i] && determined_[i] && (pivot < 0 || exceeds(normal_[i][i], normal_[pivot][pivot]))) pivot = i;
    if (pivot < 0) break;
    done[pivot] = true;
    if (exceeds(power_of_two(-16), normal_[pivot][pivot])) {
      determined_[pivot] = false;
      for (int j = 0; j < n; ++j) inverse_[pivot][j] = inverse_[j][pivot] = normal_[pivot][j] = normal_[j][pivot] = {};
      continue;
    }
    const Scaled by = kScaledOne / normal_[pivot][pivot];
    scale_row(normal_[pivot], n, by);
    scale_row(inverse_[pivot], n, by);
    for (int i = 0; i < n; ++i) {
      if (i == pivot || normal_[i][pivot].is_zero()) continue;
      const Scaled factor = normal_[i][pivot];
      take_off(normal_[i], n, factor, normal_[pivot]);
      take_off(inverse_[i], n, factor, inverse_[pivot]);
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (!inverse_[i][j].is_zero()) inverse_[i][j] /= scale[i] * scale[j];
}

// Scores of the estimated terms at parameter_, and the inverse of their matrix.
void ScoreTest::find_base() {
  const ProbePlan& plan = sums_->plan();
  for (int k = 0; k < unknowns_; ++k) {
    determined_[k] = false;
    base_doubt_[k] = Scaled{};
    for (int j = 0; j < unknowns_; ++j) normal_[k][j] = Scaled{};
    for (int s = 0; s < stretches_; ++s, report_work(15)) base_score_[s][k] = {};
  }
  for (int p = 0; p < plan.place_count; ++p) weigh(p);
  for (int j = 0; j < plan.base_count; ++j) add_base(plan.probe[j]);
  invert();
}

// What each stretch adds to the step of an unknown; returns the step.
Scaled ScoreTest::step_of(int unknown, Scaled* share) const {
  Scaled step;
  ShortScaled inverse[kMaxUnknowns];
  for (int j = 0; j < unknowns_; ++j) inverse[j] = short_scaled(inverse_[unknown][j]);
  for (int s = 0; s < stretches_; ++s, report_work(200 + 100 * unknowns_)) {
    share[s] = sum_of_arrays<kMaxUnknowns>(unknowns_, inverse, base_score_[s]);
    step += share[s];
  }
  return step;
}

// Step of every unknown, kept where it is wanted, its deviation from the stretches' shares, and what of it noise of a doubtful size may
// be. Shares whose noise goes with the root of their information d have sum s^2 about sum d and sum s^4 about 3 sum d^2: so many
// stretches tell the deviation.
void ScoreTest::measure_step(bool keeps) {
  for (int k = 0; k < unknowns_; ++k) {
    CoefficientTest& tested = tested_[k];
    tested.difference_std = tested.difference_doubt = Scaled{};
    if (!determined_[k]) continue;
    const Scaled step = step_of(k, left_), mean = step / stretches_;
    if (keeps) tested.difference = step;
    Scaled squares, fourths;
    for (int s = 0; s < stretches_; ++s, report_work(150)) {
      const Scaled one = square(left_[s] - mean);
      squares += one;
      multiply_add(fourths, one, one);
    }
    tested.difference_std = sqrt(squares);
    const Scaled stretches = quotient(Scaled::from_int(3) * square(squares), fourths);
    tested.difference_tenths = static_cast<uint16_t>(tenths_of_limit(stretches - kScaledOne, Chance::kOfDoubt));
    if (!kKeepsProbeNoise) continue;
    for (int j = 0; j < unknowns_; ++j) multiply_add(tested.difference_doubt, inverse_[k][j], base_doubt_[j]);
    tested.difference_doubt = abs(tested.difference_doubt);
  }
}

// Goes to the coefficients that the score tests' own instrument and blocks give, for the scatter of the stretches is to be taken
// there: at others it holds what they are off by, times how unlike the stretches are, and hides a force behind it. The scores'
// sums do not depend on it. Where the tests' own fit is hardly determined the estimates stay: they are nearer to any truth.
void ScoreTest::settle(const Estimates& estimates) {
  find_base();
  measure_step(true);
  for (int k = 0; k < unknowns_; ++k)
    if (tested_[k].difference_std > estimates.parameters[k].std * kLeastCertain) return;
  for (int k = 0; k < unknowns_; ++k) parameter_[k] += tested_[k].difference;
  find_base();
  measure_step(false);
}

}  // namespace firmware
