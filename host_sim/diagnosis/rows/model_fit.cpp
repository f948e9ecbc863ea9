#include "model_fit.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

// The friction held near reversals is in the covariance and, as what it absorbs, in chi-squared: each counts half.
constexpr double kShareOfDeterminant = 0.5;

// Index of each active term's own column, or -1.
std::vector<Eigen::Index> own_columns(const std::vector<ActiveTerm>& model, Eigen::Index* count) {
  std::vector<Eigen::Index> own(model.size(), -1);
  *count = 0;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known && model[i].host < 0) own[i] = (*count)++;
  return own;
}

std::shared_ptr<const Spectra> sum_of(const Spectra& a, const Spectra& b, double factor) {
  auto sum = std::make_shared<Spectra>(a);
  for (size_t r = 0; r < a.size(); ++r) (*sum)[r] += factor * b[r];
  return sum;
}

}  // namespace

Fit fit_model(const Rows& rows, std::vector<ActiveTerm>& model) {
  Eigen::Index count = 0;
  const std::vector<Eigen::Index> own = own_columns(model, &count);
  std::vector<FittedColumn> columns(static_cast<size_t>(count));
  std::vector<Balance> target = rows.force();
  const auto take_away = [&](const ActiveTerm& t, double value) {
    for (size_t r = 0; r < target.size(); ++r) act(target[r], rows.place(t.term), t.column->spectra[r], -value);
  };
  for (size_t i = 0; i < model.size(); ++i) {
    const ActiveTerm& t = model[i];
    const ActiveTerm* host = t.host >= 0 ? &model[static_cast<size_t>(t.host)] : nullptr;
    const Eigen::Index index = host ? own[static_cast<size_t>(t.host)] : own[i];
    if (index < 0) {
      take_away(t, acting_value(model, t));
      continue;
    }
    FittedColumn& c = columns[static_cast<size_t>(index)];
    c.place = rows.place(t.term);  // a term and its host are on the same link
    c.spectra = c.spectra ? sum_of(*c.spectra, t.column->spectra, host ? t.host_sign : 1)
                          : std::shared_ptr<const Spectra>(t.column, &t.column->spectra);
  }
  const auto projection = std::make_shared<Projection>(rows.weights(), std::move(columns), target);
  Fit fit;
  fit.projection = projection;
  fit.chi2 = projection->chi2() + rows.absorbed();
  fit.cost = fit.chi2 + kShareOfDeterminant * rows.log_determinant();
  fit.dof = static_cast<double>(std::max<Eigen::Index>(1, rows.size() - count));
  const double widen = std::sqrt(std::max(1.0, fit.ratio()));
  for (size_t i = 0; i < model.size(); ++i)
    if (own[i] >= 0) model[i].value = projection->value(own[i]), model[i].std = projection->std(own[i]) * widen;
  for (ActiveTerm& t : model)
    if (t.host >= 0) {
      t.value = t.host_sign * model[static_cast<size_t>(t.host)].value;
      t.std = model[static_cast<size_t>(t.host)].std;
    }
  return fit;
}

Fit settle(Rows& rows, std::vector<ActiveTerm>& model, int rounds) {
  Fit fit;
  for (ActiveTerm& t : model) rows.prepare(t);
  for (int i = 0; i < rounds; ++i) {
    rows.hold_stuck(model);
    rows.weight(model);
    fit = fit_model(rows, model);
  }
  return fit;
}

std::vector<ActiveTerm> joined(const std::vector<ActiveTerm>& model, const Candidate& c, const Gain& gain) {
  std::vector<ActiveTerm> out = model;
  ActiveTerm t;
  t.term = c.term();
  t.column = c.column;
  t.added = true;
  t.host = c.host;
  t.host_sign = c.host_sign;
  t.known = c.fixed;
  t.value = c.fixed ? c.host_sign * model[static_cast<size_t>(c.host)].value : gain.coefficient;
  t.std = gain.std;
  out.push_back(t);
  for (const auto& column : c.companions) {
    ActiveTerm companion;
    companion.term = column->term;
    companion.column = column;
    companion.companion = static_cast<int>(model.size());
    out.push_back(companion);
  }
  return out;
}

void remove_term(std::vector<ActiveTerm>& model, size_t index) {
  model.erase(model.begin() + static_cast<std::ptrdiff_t>(index));
  for (size_t i = model.size(); i-- > 0;) {
    if (model[i].host == static_cast<int>(index) || model[i].companion == static_cast<int>(index)) {
      model[i].host = model[i].companion = -1;
      remove_term(model, i);
      continue;
    }
    if (model[i].host > static_cast<int>(index)) --model[i].host;
    if (model[i].companion > static_cast<int>(index)) --model[i].companion;
  }
}

std::vector<ActiveTerm> on_rows(const Rows& rows, std::vector<ActiveTerm> model) {
  for (ActiveTerm& t : model) t.column = rows.column(t.term), t.force.reset();
  return model;
}

std::vector<ActiveTerm> without_added(std::vector<ActiveTerm> model, const Term& term) {
  for (size_t i = 0; i < model.size(); ++i) {
    if (!model[i].added || !model[i].term.same_place(term)) continue;
    remove_term(model, i);
    break;
  }
  return model;
}

}  // namespace diagnosis
