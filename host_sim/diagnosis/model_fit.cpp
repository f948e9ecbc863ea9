#include "model_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

// Index of each active term's own column, or -1.
std::vector<Eigen::Index> own_columns(const std::vector<ActiveTerm>& model, Eigen::Index* count) {
  std::vector<Eigen::Index> own(model.size(), -1);
  *count = 0;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known && model[i].host < 0) own[i] = (*count)++;
  return own;
}

}  // namespace

Fit fit_model(const Rows& rows, std::vector<ActiveTerm>& model) {
  Fit fit;
  Eigen::Index count = 0;
  const std::vector<Eigen::Index> own = own_columns(model, &count);
  fit.columns = Eigen::MatrixXd::Zero(rows.size(), count);
  fit.target = rows.whitened_force();
  for (size_t i = 0; i < model.size(); ++i) {
    const ActiveTerm& t = model[i];
    const Series column = rows.whitened(t.column);
    const Eigen::Index host = t.host >= 0 ? own[static_cast<size_t>(t.host)] : -1;
    if (host >= 0) fit.columns.col(host) += t.host_sign * column;
    else if (t.host >= 0) fit.target -= t.host_sign * model[static_cast<size_t>(t.host)].value * column;
    else if (t.known) fit.target -= t.value * column;
    else fit.columns.col(own[i]) += column;
  }
  const Eigen::VectorXd scale = fit.columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd scaled = fit.columns * scale.asDiagonal();
  Eigen::VectorXd value = Eigen::VectorXd::Zero(count), variance = value;
  fit.basis.resize(rows.size(), 0);
  if (count > 0) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
    fit.basis = qr.householderQ() * Eigen::MatrixXd::Identity(rows.size(), count);
    Eigen::MatrixXd r = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
    for (Eigen::Index i = 0; i < count; ++i)
      if (std::abs(r(i, i)) < 1e-9) r(i, i) = 1e9;  // a column of no effect: its value stays near zero
    const Eigen::MatrixXd inverse = r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(count, count));
    value = inverse * (fit.basis.transpose() * fit.target);
    variance = inverse.rowwise().squaredNorm();
  }
  fit.residual = fit.target - scaled * value;
  fit.chi2 = fit.residual.squaredNorm() + rows.absorbed();
  fit.dof = static_cast<double>(std::max<Eigen::Index>(1, rows.size() - count));
  const double widen = std::sqrt(std::max(1.0, fit.ratio()));
  for (size_t i = 0; i < model.size(); ++i)
    if (own[i] >= 0) {
      model[i].value = value[own[i]] * scale[own[i]];
      model[i].std = std::sqrt(variance[own[i]]) * scale[own[i]] * widen;
    }
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

Gain gain_of(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit, const Candidate& c) {
  Gain gain;
  const Series column = rows.whitened(*c.column);
  const double whole = column.squaredNorm();
  Eigen::Index count = 0;
  const std::vector<Eigen::Index> own = own_columns(model, &count);
  const Eigen::Index host = c.host >= 0 && !c.fixed ? own[static_cast<size_t>(c.host)] : -1;
  if (host >= 0) {  // the host's column changes its shape: fit again from the products
    Eigen::MatrixXd columns = fit.columns;
    columns.col(host) += c.host_sign * column;
    const Eigen::VectorXd scale = columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    columns = columns * scale.asDiagonal();
    const Eigen::MatrixXd gram = columns.transpose() * columns;
    const Eigen::VectorXd moment = columns.transpose() * fit.target;
    const Eigen::LDLT<Eigen::MatrixXd> solver(gram);
    const Eigen::VectorXd value = solver.solve(moment);
    gain.chi2 = fit.chi2 - rows.absorbed() - (fit.target - columns * value).squaredNorm();
    gain.coefficient = c.host_sign * value[host] * scale[host];
    gain.std = model[static_cast<size_t>(c.host)].std;
    return gain;
  }
  const double free = whole - (fit.basis.transpose() * column).squaredNorm();
  if (!(free > 1e-7 * whole) || whole <= 0) return gain;
  const double moment = column.dot(fit.residual);
  if (!c.companions.empty()) {
    Eigen::MatrixXd group(column.size(), static_cast<Eigen::Index>(1 + c.companions.size()));
    group.col(0) = column;
    for (size_t i = 0; i < c.companions.size(); ++i) group.col(static_cast<Eigen::Index>(i) + 1) = rows.whitened(*c.companions[i]);
    group -= fit.basis * (fit.basis.transpose() * group);
    const Eigen::MatrixXd gram = group.transpose() * group;
    const Eigen::VectorXd moments = group.transpose() * fit.residual;
    const Eigen::LDLT<Eigen::MatrixXd> solver(gram);
    const Eigen::VectorXd value = solver.solve(moments);
    gain.coefficient = value[0], gain.std = 1 / std::sqrt(free);
    gain.chi2 = gain.coefficient * c.coefficient_sign < 0 ? 0 : value.dot(moments);
    return gain;
  }
  gain.coefficient = c.fixed ? c.host_sign * model[static_cast<size_t>(c.host)].value : moment / free;
  gain.std = 1 / std::sqrt(free);
  if (gain.coefficient * c.coefficient_sign < 0) return Gain{0, 0, gain.std};
  gain.chi2 = 2 * gain.coefficient * moment - gain.coefficient * gain.coefficient * free;
  return gain;
}

std::vector<ActiveTerm> joined(const std::vector<ActiveTerm>& model, const Candidate& c, const Gain& gain) {
  std::vector<ActiveTerm> out = model;
  ActiveTerm t;
  t.column = *c.column;
  t.added = true;
  t.host = c.host;
  t.host_sign = c.host_sign;
  t.known = c.fixed;
  t.value = c.fixed ? c.host_sign * model[static_cast<size_t>(c.host)].value : gain.coefficient;
  t.std = gain.std;
  out.push_back(t);
  for (const auto& column : c.companions) {
    ActiveTerm companion;
    companion.column = *column;
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

}  // namespace diagnosis
