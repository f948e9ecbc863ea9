// The scores of the estimated terms: residuals, weights of the places, the normal matrix and its inverse.
#include "firmware/warrant/score_test.hpp"

namespace firmware {
namespace {

constexpr int kLeastForWeights = 8;  // stretches of a level that show its own scatter

Scaled square(Scaled value) { return value * value; }

}  // namespace

// Mean time of a stretch since its level's start, where the probe's force grows with it; else 1.
Scaled ScoreTest::time(const Probe& probe, int s) const {
  if (!probe.drifts) return Scaled::from_int(1);
  const Stretch& stretch = sums_->table().stretch(s);
  return configuration_->sample_period_s * Scaled::ratio(static_cast<int64_t>(stretch.time), stretch.blocks);
}

// The sums of one probe in SI units, its residuals at the estimates.
void ScoreTest::read(const Probe& probe) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[probe.place];
  const int sums = place.equations + place.columns, values = plan.values(probe);
  Scaled unit[kPlaceEquations + kMaxPlaceColumns + 3], noise[2][kPlaceEquations + kMaxPlaceColumns];
  for (int v = 0; v < values; ++v) unit[v] = sums_->unit(probe, v);
  for (int slope = 0; slope < plan.slopes; ++slope)
    for (int v = 0; v < sums; ++v) noise[slope][v] = sums_->noise_share(probe, slope, v, SharedNoise::Of::kWhole);
  read_doubt(probe);
  for (int s = 0; s < stretches_; ++s) {
    const Scaled since = time(probe, s);
    const auto raw = [&](int v) {
      const Scaled sum = sums_->table().value(s, probe.first_value + v) * unit[v];
      return probe.drifts ? sum * since : sum;
    };
    Scaled slopes[2];
    for (int slope = 0; slope < plan.slopes; ++slope) slopes[slope] = raw(sums + 1 + slope);
    const auto value = [&](int v) {
      Scaled sum = raw(v);
      for (int slope = 0; slope < plan.slopes; ++slope)
        if (!noise[slope][v].is_zero()) sum = sum - slopes[slope] * noise[slope][v];
      return sum;
    };
    for (int e = 0; e < place.equations; ++e) residual_[s][e] = value(e);
    for (int k = 0; k < place.columns; ++k) {
      column_[s][k] = value(place.equations + k);
      const Scaled force = column_[s][k] * parameter_[place.unknown[k]];
      for (int e = 0; e < place.equations; ++e) {
        if (place.column_sign[k][e] > 0) residual_[s][e] = residual_[s][e] - force;
        if (place.column_sign[k][e] < 0) residual_[s][e] = residual_[s][e] + force;
      }
    }
    own_[s] = probe.drifts ? raw(sums) * since : raw(sums);
  }
}

// What of the probe's residuals is noise of a doubtful size: the sums of its slopes over a level, times the covariances.
void ScoreTest::read_doubt(const Probe& probe) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[probe.place];
  const int sums = place.equations + place.columns;
  for (auto& level : doubtful_)
    for (Scaled& equation : level) equation = Scaled{};
  for (int slope = 0; slope < plan.slopes; ++slope) {
    Scaled total[kMaxLevels], share[kPlaceEquations];
    const int value = probe.first_value + sums + 1 + slope;
    for (int s = 0; s < stretches_; ++s)
      total[level_of_[s]] = total[level_of_[s]] + sums_->table().value(s, value) * time(probe, s);
    for (int e = 0; e < place.equations; ++e) {
      share[e] = sums_->noise_share(probe, slope, e, SharedNoise::Of::kDoubtful);
      for (int k = 0; k < place.columns; ++k) {
        if (place.column_sign[k][e] == 0) continue;
        const Scaled part = parameter_[place.unknown[k]] *
                            sums_->noise_share(probe, slope, place.equations + k, SharedNoise::Of::kDoubtful);
        share[e] = place.column_sign[k][e] > 0 ? share[e] - part : share[e] + part;
      }
      share[e] = share[e] * sums_->unit(probe, sums + 1 + slope);
    }
    for (int level = 0; level < levels_; ++level)
      for (int e = 0; e < place.equations; ++e) doubtful_[level][e] = doubtful_[level][e] + total[level] * share[e];
  }
}

// The same in the whole score.
Scaled ScoreTest::doubtful_score(int place) const {
  Scaled sum;
  for (int level = 0; level < levels_; ++level)
    for (int e = 0; e < sums_->plan().place[place].equations; ++e)
      sum = sum + weight_[place][level][e] * doubtful_[level][e];
  return sum;
}

// From the scores of the place's rate (on a DOF, of its acceleration).
void ScoreTest::weigh(int number) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[number];
  const Form wanted = place.kind == PlaceKind::kDof ? Form::kAcceleration : Form::kRate;
  int found = -1;
  for (int j = plan.summed_count - 1; j >= 0; --j)
    if (plan.probe[j].place == number && (found < 0 || plan.probe[j].form == wanted)) found = j;
  if (found < 0) return;
  read(plan.probe[found]);
  for (int level = 0; level < levels_; ++level) weigh_level(place, level, number);
}

void ScoreTest::weigh_level(const Place& place, int level, int number) {
  Scaled covariance[kPlaceEquations][kPlaceEquations], own;
  int counted = 0;
  for (int pass = 0; pass < 2 && counted < kLeastForWeights; ++pass) {  // all levels where one alone is too short
    own = Scaled{};
    counted = 0;
    for (auto& row : covariance)
      for (Scaled& entry : row) entry = Scaled{};
    for (int s = 0; s < stretches_; ++s) {
      if (pass == 0 && level_of_[s] != level) continue;
      ++counted;
      own = own + abs(own_[s]);
      for (int e = 0; e < place.equations; ++e)
        for (int f = 0; f < place.equations; ++f)
          covariance[e][f] = covariance[e][f] + residual_[s][e] * residual_[s][f];
    }
  }
  Scaled* g = weight_[number][level];
  for (int e = 0; e < place.equations; ++e)
    covariance[e][e] = covariance[e][e] + scale_by_power_of_two(covariance[e][e], -6);
  const Scaled& a = covariance[0][0];
  const Scaled& b = covariance[0][1];
  const Scaled& c = covariance[1][1];
  if (place.equations == 1 || b.is_zero() || a.is_zero() || c.is_zero()) {
    for (int e = 0; e < place.equations; ++e) {
      g[e] = covariance[e][e].is_zero() ? Scaled::from_int(1) : own / covariance[e][e];
      if (place.sign[e] < 0) g[e] = -g[e];
    }
    return;
  }
  const Scaled determinant = a * c - b * b, scale = own / determinant;
  const Scaled first = place.sign[0] < 0 ? Scaled::from_int(-1) : Scaled::from_int(1);
  const Scaled second = place.sign[1] < 0 ? Scaled::from_int(-1) : Scaled::from_int(1);
  g[0] = (c * first - b * second) * scale;
  g[1] = (a * second - b * first) * scale;
}

void ScoreTest::add_base(const Probe& probe) {
  const Place& place = sums_->plan().place[probe.place];
  const int row = probe.unknown;
  place_of_unknown_[row] = probe.place;
  determined_[row] = true;
  read(probe);
  for (int s = 0; s < stretches_; ++s) {
    Scaled score;
    for (int e = 0; e < place.equations; ++e) {
      const Scaled g = weight(probe.place, s, e);
      score = score + g * residual_[s][e];
      for (int k = 0; k < place.columns; ++k) {
        Scaled& entry = normal_[row][place.unknown[k]];
        if (place.column_sign[k][e] > 0) entry = entry + g * column_[s][k];
        if (place.column_sign[k][e] < 0) entry = entry - g * column_[s][k];
      }
    }
    base_score_[s][row] = score;
  }
  base_doubt_[row] = doubtful_score(probe.place);
}

// Gauss-Jordan with the largest pivot of what is left, rows and columns scaled; a term that is a combination of others is
// left out (it keeps the estimator's value).
void ScoreTest::invert() {
  const int n = unknowns_;
  Scaled scale[kMaxUnknowns];
  bool done[kMaxUnknowns] = {};
  for (int i = 0; i < n; ++i) {
    scale[i] = sqrt(abs(normal_[i][i]));
    if (scale[i].is_zero()) determined_[i] = false;
    for (int j = 0; j < n; ++j) inverse_[i][j] = Scaled{};
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      normal_[i][j] = determined_[i] && determined_[j] ? normal_[i][j] / (scale[i] * scale[j]) : Scaled{};
  for (int i = 0; i < n; ++i)
    if (determined_[i]) inverse_[i][i] = Scaled::from_int(1);
  for (int turn = 0; turn < n; ++turn) {
    int pivot = -1;
    for (int i = 0; i < n; ++i)
      if (!done[i] && determined_[i] && (pivot < 0 || abs(normal_[i][i]) > abs(normal_[pivot][pivot]))) pivot = i;
    if (pivot < 0) break;
    done[pivot] = true;
    if (abs(normal_[pivot][pivot]) < Scaled::from_int(1, -16)) {
      determined_[pivot] = false;
      for (int j = 0; j < n; ++j) inverse_[pivot][j] = inverse_[j][pivot] = normal_[pivot][j] = normal_[j][pivot] = {};
      continue;
    }
    const Scaled by = Scaled::from_int(1) / normal_[pivot][pivot];
    for (int j = 0; j < n; ++j) {
      normal_[pivot][j] = normal_[pivot][j] * by;
      inverse_[pivot][j] = inverse_[pivot][j] * by;
    }
    for (int i = 0; i < n; ++i) {
      if (i == pivot || normal_[i][pivot].is_zero()) continue;
      const Scaled factor = normal_[i][pivot];
      for (int j = 0; j < n; ++j) {
        normal_[i][j] = normal_[i][j] - factor * normal_[pivot][j];
        inverse_[i][j] = inverse_[i][j] - factor * inverse_[pivot][j];
      }
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (!inverse_[i][j].is_zero()) inverse_[i][j] = inverse_[i][j] / (scale[i] * scale[j]);
}

// One step of the fit with the score tests' own instrument, its deviation from the stretches' shares.
void ScoreTest::compare() {
  for (int k = 0; k < unknowns_; ++k) {
    difference_[k] = difference_std_[k] = difference_doubt_[k] = Scaled{};
    if (!determined_[k]) continue;
    Scaled share[kMostStretches], squares;
    for (int s = 0; s < stretches_; ++s) {
      for (int j = 0; j < unknowns_; ++j)
        if (!inverse_[k][j].is_zero()) share[s] = share[s] + inverse_[k][j] * base_score_[s][j];
      difference_[k] = difference_[k] + share[s];
    }
    for (int j = 0; j < unknowns_; ++j) difference_doubt_[k] = difference_doubt_[k] + inverse_[k][j] * base_doubt_[j];
    difference_doubt_[k] = abs(difference_doubt_[k]);
    const Scaled mean = difference_[k] / Scaled::from_int(stretches_);
    for (int s = 0; s < stretches_; ++s) squares = squares + square(share[s] - mean);
    difference_std_[k] = sqrt(squares);
  }
}

}  // namespace firmware
