#include "information.hpp"

#include <cmath>

namespace diagnosis {

void act(Balance& balance, const Place& place, const Spectrum& force, double factor) {
  if (place.plus >= 0) balance.col(place.plus) += factor * force;
  if (place.minus >= 0) balance.col(place.minus) -= factor * force;
}

void act(Eigen::MatrixXd& matrix, const Place& p, double value) {
  if (p.plus >= 0) matrix(p.plus, p.plus) += value;
  if (p.minus >= 0) matrix(p.minus, p.minus) += value;
  if (p.plus >= 0 && p.minus >= 0) matrix(p.plus, p.minus) -= value, matrix(p.minus, p.plus) -= value;
}

namespace {

// Cholesky's factor in place of the lower triangle. Returns the logarithm of the determinants, summed over the bins.
double factorise(Triangle& s, Eigen::Index n, std::vector<Series>& inverse_diagonal) {
  double logarithm = 0;
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index k = 0; k <= j; ++k) {
      Spectrum& entry = s[in_triangle(j, k)];
      for (Eigen::Index l = 0; l < k; ++l)
        entry.array() -= s[in_triangle(j, l)].array() * s[in_triangle(k, l)].array().conjugate();
      if (k < j) {
        entry.array() *= inverse_diagonal[static_cast<size_t>(k)].array();
        continue;
      }
      const Series square = entry.real().cwiseMax(1e-300);
      logarithm += square.array().log().sum();
      inverse_diagonal.push_back(square.cwiseSqrt().cwiseInverse());
    }
  return logarithm;
}

// The inverse of the factor in place of it.
void invert(Triangle& s, Eigen::Index n, const std::vector<Series>& inverse_diagonal) {
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto scale = inverse_diagonal[static_cast<size_t>(j)].array();
    for (Eigen::Index k = 0; k < j; ++k) {
      Spectrum sum = s[in_triangle(j, k)].cwiseProduct(s[in_triangle(k, k)]);
      for (Eigen::Index l = k + 1; l < j; ++l) sum += s[in_triangle(j, l)].cwiseProduct(s[in_triangle(l, k)]);
      s[in_triangle(j, k)] = -scale * sum.array();
    }
    s[in_triangle(j, j)] = scale.cast<Complex>();
  }
}

}  // namespace

Information::Information(Eigen::Index dofs, Triangle s)
    : bins_(s[0].size()), dofs_(dofs), entries_(static_cast<size_t>(dofs * dofs)) {
  Series trace = Series::Zero(bins_);
  for (Eigen::Index j = 0; j < dofs; ++j) trace += s[in_triangle(j, j)].real();
  for (Eigen::Index j = 0; j < dofs; ++j) s[in_triangle(j, j)].array() += 1e-12 * trace.array() + 1e-280;
  std::vector<Series> inverse_diagonal;
  log_determinant_ = factorise(s, dofs, inverse_diagonal);
  invert(s, dofs, inverse_diagonal);
  for (Eigen::Index j = 0; j < dofs; ++j)
    for (Eigen::Index k = 0; k <= j; ++k) {
      Spectrum sum = s[in_triangle(j, j)].conjugate().cwiseProduct(s[in_triangle(j, k)]);
      for (Eigen::Index l = j + 1; l < dofs; ++l)
        sum += s[in_triangle(l, j)].conjugate().cwiseProduct(s[in_triangle(l, k)]);
      entries_[static_cast<size_t>(j * dofs + k)] = sum;
      if (k < j) entries_[static_cast<size_t>(k * dofs + j)] = sum.conjugate();
    }
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
