// What one more term would gain, from inner products alone.
#include <Eigen/Cholesky>
#include <cmath>

#include "../rows/model_fit.hpp"

namespace diagnosis {
namespace {

// One column's products with a fit.
struct Shared {
  Eigen::VectorXd fitted;
  double moment = 0, whole = 0;
  double free() const { return whole - fitted.squaredNorm(); }  // square of what the fitted columns cannot make of it
};

Shared column_of(const Projection::Products& p, Eigen::Index i) {
  return {p.fitted.col(i), p.residual[i], p.square[i]};
}

// Index of the fitted column of an active term, or -1.
Eigen::Index fitted_index(const std::vector<ActiveTerm>& model, int term) {
  const ActiveTerm& t = model[static_cast<size_t>(term)];
  if (t.known || t.host >= 0) return -1;
  Eigen::Index index = 0;
  for (int i = 0; i < term; ++i)
    index += !model[static_cast<size_t>(i)].known && model[static_cast<size_t>(i)].host < 0;
  return index;
}

// The column shares the coefficient b of fitted column h, with sign s. Least squares over all columns with the further
// one free, and then held to s b by a Lagrange multiplier: m the moment with the residual, f the free square, k how b
// answers to the new coefficient, v the variance of b. Written so that f may go to nought.
Gain hosted_gain(const Projection& p, const Shared& c, Eigen::Index h, double s) {
  const double k = 1 + s * p.answer(h, c.fitted), v = p.std(h) * p.std(h), f = c.free(), m = c.moment,
               b = s * p.value(h);
  const double sum = k * k + f * v;
  return {(m * m * v + 2 * k * m * b - b * b * f) / sum, (m * v + k * b) / sum, 0};
}

// A column that comes with others, free in sign.
Gain group_gain(const Fit& fit, const Place& place, const Candidate& c) {
  std::vector<const Spectra*> list{&c.column->spectra};
  for (const auto& companion : c.companions) list.push_back(&companion->spectra);
  const Projection::Products p = fit.projection->products(place, list);
  const Shared own = column_of(p, 0);
  if (!(own.free() > 1e-7 * own.whole)) return {};
  const Eigen::MatrixXd gram = fit.projection->free_gram(place, list, p, 0, p.residual.size());
  const Eigen::VectorXd value = gram.ldlt().solve(p.residual);
  Gain gain{value.dot(p.residual), value[0], 1 / std::sqrt(own.free())};
  if (gain.coefficient * c.coefficient_sign < 0) gain.chi2 = 0;
  return gain;
}

Gain single_gain(const std::vector<ActiveTerm>& model, const Fit& fit, const Candidate& c, const Shared& column) {
  const Eigen::Index host = c.host >= 0 && !c.fixed ? fitted_index(model, c.host) : -1;
  if (host >= 0) {
    Gain gain = hosted_gain(*fit.projection, column, host, c.host_sign);
    gain.std = model[static_cast<size_t>(c.host)].std;
    return gain;
  }
  const double free = column.free();
  Gain gain;
  if (!(free > 1e-7 * column.whole) || column.whole <= 0) return gain;
  gain.coefficient = c.fixed ? c.host_sign * model[static_cast<size_t>(c.host)].value : column.moment / free;
  gain.std = 1 / std::sqrt(free);
  if (gain.coefficient * c.coefficient_sign < 0) return Gain{0, 0, gain.std};
  gain.chi2 = 2 * gain.coefficient * column.moment - gain.coefficient * gain.coefficient * free;
  return gain;
}

}  // namespace

std::vector<Gain> gains_of(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit,
                           const std::vector<Candidate>& candidates) {
  std::vector<Gain> gains(candidates.size());
  std::map<Place, std::vector<size_t>> places;
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Place place = rows.place(candidates[i].term());
    if (!candidates[i].companions.empty())
      gains[i] = group_gain(fit, place, candidates[i]);
    else
      places[place].push_back(i);
  }
  for (const auto& here : places) {
    std::vector<const Spectra*> columns;
    for (size_t i : here.second) columns.push_back(&candidates[i].column->spectra);
    const Projection::Products p = fit.projection->products(here.first, columns);
    for (size_t k = 0; k < here.second.size(); ++k)
      gains[here.second[k]] =
          single_gain(model, fit, candidates[here.second[k]], column_of(p, static_cast<Eigen::Index>(k)));
  }
  return gains;
}

Gain gain_of(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit, const Candidate& c) {
  return gains_of(rows, model, fit, {c}).front();
}

}  // namespace diagnosis
