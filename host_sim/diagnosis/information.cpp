#include "information.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace diagnosis {

void act(Balance& balance, const Place& place, const Spectrum& force, double factor) {
  if (place.plus >= 0) balance.col(place.plus) += factor * force;
  if (place.minus >= 0) balance.col(place.minus) -= factor * force;
}

Information::Information(Eigen::Index bins, Eigen::Index dofs)
    : bins_(bins), dofs_(static_cast<int>(dofs)), entries_(static_cast<size_t>(dofs * dofs), Spectrum(bins)) {}

double Information::set(Eigen::Index bin, const SmallMatrix& covariance) {
  if (dofs_ == 1) {
    const double variance = covariance(0, 0).real() * (1 + 1e-12) + 1e-280;
    entries_[0][bin] = 1 / variance;
    return std::log(variance);
  }
  SmallMatrix s = covariance, inverse = SmallMatrix::Identity(dofs_, dofs_);
  s.diagonal().array() += 1e-12 * s.diagonal().real().sum() + 1e-280;
  const Eigen::LLT<SmallMatrix> factor(s);
  factor.solveInPlace(inverse);
  for (int j = 0; j < dofs_; ++j)
    for (int k = 0; k < dofs_; ++k) entries_[static_cast<size_t>(j * dofs_ + k)][bin] = inverse(j, k);
  return 2 * factor.matrixLLT().diagonal().real().array().log().sum();
}

Spectrum Information::between(const Place& p, const Place& q) const {
  Spectrum sum = Spectrum::Zero(bins_);
  if (p.plus >= 0 && q.plus >= 0) sum += at(p.plus, q.plus);
  if (p.plus >= 0 && q.minus >= 0) sum -= at(p.plus, q.minus);
  if (p.minus >= 0 && q.plus >= 0) sum -= at(p.minus, q.plus);
  if (p.minus >= 0 && q.minus >= 0) sum += at(p.minus, q.minus);
  return sum;
}

Series Information::weight(const Place& p) const { return between(p, p).real().cwiseMax(0.0); }

Spectrum Information::pulled(const Place& p, const Balance& balance) const {
  Spectrum sum = Spectrum::Zero(bins_);
  for (int k = 0; k < dofs_; ++k) {
    if (p.plus >= 0) sum += at(p.plus, k).cwiseProduct(balance.col(k));
    if (p.minus >= 0) sum -= at(p.minus, k).cwiseProduct(balance.col(k));
  }
  return sum;
}

Series Information::power(const Balance& balance) const {
  Series sum = Series::Zero(bins_);
  for (int j = 0; j < dofs_; ++j)
    sum += (balance.col(j).conjugate().array() * pulled({j, -1}, balance).array()).real().matrix();
  return sum.cwiseMax(0.0);
}

}  // namespace diagnosis
