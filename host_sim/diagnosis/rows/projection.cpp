#include "projection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

constexpr double kNotSeen =
    1e-7;  // share of a disturbance's square beyond the fitted columns below which it does not show
constexpr double kDependent =
    1e-13;  // share of a column's square beyond the others below which it has no value of its own
constexpr Eigen::Index kBlock = 1024;  // real rows that are worked on at a time: they stay in the cache

using RealView = Eigen::Map<const Series>;
RealView real_view(const Spectrum& s) { return {reinterpret_cast<const double*>(s.data()), 2 * s.size()}; }

}  // namespace

Projection::Projection(std::shared_ptr<const Weights> weights, std::vector<FittedColumn> columns,
                       const std::vector<Balance>& target)
    : weights_(std::move(weights)), columns_(std::move(columns)), residual_(target) {
  const Eigen::Index count = static_cast<Eigen::Index>(columns_.size());
  value_ = Eigen::VectorXd::Zero(count);
  factorise(gram());
  for (int pass = 0; pass < 2 && count > 0; ++pass) {  // the second takes back what rounding cost the first
    const Eigen::VectorXd step =
        scale_.asDiagonal() * (inverse_ * (inverse_.transpose() * (scale_.asDiagonal() * moments(residual_))));
    value_ += step;
    for (size_t i = 0; i < columns_.size(); ++i)
      for (size_t r = 0; r < residual_.size(); ++r)
        act(residual_[r], columns_[i].place, (*columns_[i].spectra)[r], -step[static_cast<Eigen::Index>(i)]);
  }
  for (auto& seen : views_) add_residual(seen.first, seen.second);
}

double Projection::chi2() const {
  double sum = 0;
  for (size_t r = 0; r < residual_.size(); ++r) sum += (*weights_)[r].power(residual_[r]).sum();
  return sum;
}

Eigen::MatrixXd Projection::gram() const {
  const Eigen::Index count = static_cast<Eigen::Index>(columns_.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const FittedColumn& c = columns_[static_cast<size_t>(i)];
    std::vector<View>& views = views_[c.place];
    if (views.empty()) views = fitted_from(c.place);
    for (size_t r = 0; r < views.size(); ++r)
      matrix.row(i) += real_view((*c.spectra)[r]).transpose() * views[r].pulled.leftCols(count);
  }
  return matrix;
}

// Cholesky's factor in the order of the columns; one that the others before it can make gets no value.
void Projection::factorise(Eigen::MatrixXd normal) {
  const Eigen::Index count = normal.rows();
  scale_ = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  normal = (scale_.asDiagonal() * normal * scale_.asDiagonal()).eval();
  Eigen::MatrixXd r = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double left = normal(i, i) - r.col(i).head(i).squaredNorm();
    if (left < kDependent) {
      r(i, i) = 1e9;
      continue;
    }
    r(i, i) = std::sqrt(left);
    for (Eigen::Index j = i + 1; j < count; ++j)
      r(i, j) = (normal(i, j) - r.col(i).head(i).dot(r.col(j).head(i))) / r(i, i);
  }
  inverse_ = r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(count, count));
}

Eigen::VectorXd Projection::moments(const std::vector<Balance>& balance) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns_.size()));
  std::map<Place, Spectra> pulled;
  for (size_t i = 0; i < columns_.size(); ++i) {
    Spectra& here = pulled[columns_[i].place];
    for (size_t r = 0; r < balance.size(); ++r) {
      if (here.size() == r) here.push_back((*weights_)[r].pulled(columns_[i].place, balance[r]));
      out[static_cast<Eigen::Index>(i)] += real_view((*columns_[i].spectra)[r]).dot(real_view(here[r]));
    }
  }
  return out;
}

std::vector<Projection::View> Projection::fitted_from(const Place& place) const {
  std::vector<View> views;
  const Eigen::Index count = static_cast<Eigen::Index>(columns_.size());
  for (size_t r = 0; r < weights_->size(); ++r) {
    const Information& information = (*weights_)[r];
    views.push_back({Eigen::MatrixXd(2 * information.bins(), count + 1), information.weight(place)});
    std::map<Place, Spectrum> between;
    for (Eigen::Index i = 0; i < count; ++i) {
      const FittedColumn& c = columns_[static_cast<size_t>(i)];
      Spectrum& weight = between[c.place];
      if (weight.size() == 0) weight = information.between(place, c.place);
      Spectrum::Map(reinterpret_cast<Complex*>(views[r].pulled.col(i).data()), information.bins()) =
          weight.cwiseProduct((*c.spectra)[r]);
    }
  }
  return views;
}

void Projection::add_residual(const Place& place, std::vector<View>& views) const {
  for (size_t r = 0; r < views.size(); ++r)
    views[r].pulled.rightCols(1) = real_view((*weights_)[r].pulled(place, residual_[r]));
}

const std::vector<Projection::View>& Projection::seen_from(const Place& place) const {
  std::vector<View>& views = views_[place];
  if (views.empty()) {
    views = fitted_from(place);
    add_residual(place, views);
  }
  return views;
}

Projection::Products Projection::products(const Place& place, const std::vector<const Spectra*>& list) const {
  const Eigen::Index columns = static_cast<Eigen::Index>(list.size()), count = this->count();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count + 1, columns);
  Products out{{}, {}, Eigen::VectorXd::Zero(columns)};
  Eigen::MatrixXd block(kBlock, columns);
  const std::vector<View>& views = seen_from(place);
  for (size_t r = 0; r < views.size(); ++r)
    for (Eigen::Index from = 0; from < views[r].pulled.rows(); from += kBlock) {
      const Eigen::Index rows = std::min(kBlock, views[r].pulled.rows() - from);
      for (Eigen::Index c = 0; c < columns; ++c) {
        const Spectrum& s = (*list[static_cast<size_t>(c)])[r];
        block.col(c).head(rows) = real_view(s).segment(from, rows);
        out.square[c] += views[r].weight.segment(from / 2, rows / 2).dot(s.segment(from / 2, rows / 2).cwiseAbs2());
      }
      sum.noalias() += views[r].pulled.middleRows(from, rows).transpose() * block.topRows(rows);
    }
  out.residual = sum.row(count).transpose();
  out.fitted = inverse_.transpose() * (scale_.asDiagonal() * sum.topRows(count));
  return out;
}

double Projection::inner(const Place& place, const Spectra& a, const Spectra& b) const {
  const std::vector<View>& views = seen_from(place);
  double sum = 0;
  for (size_t r = 0; r < views.size(); ++r)
    sum += (views[r].weight.array() * (a[r].conjugate().array() * b[r].array()).real()).sum();
  return sum;
}

double Projection::inner(const std::vector<Balance>& a, const std::vector<Balance>& b) const {
  double sum = 0;
  for (size_t r = 0; r < a.size(); ++r)
    for (Eigen::Index j = 0; j < a[r].cols(); ++j)
      sum += (a[r].col(j).conjugate().array() * (*weights_)[r].pulled({static_cast<int>(j), -1}, b[r]).array())
                 .real()
                 .sum();
  return sum;
}

Projection::Explained Projection::explained(const std::vector<std::vector<Balance>>& group) const {
  const Eigen::Index count = static_cast<Eigen::Index>(group.size());
  Explained out{0, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
  Eigen::MatrixXd fitted(this->count(), count), gram(count, count);
  Eigen::VectorXd moment(count);
  bool seen = true;
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::vector<Balance>& own = group[static_cast<size_t>(i)];
    fitted.col(i) = inverse_.transpose() * (scale_.asDiagonal() * moments(own));
    moment[i] = inner(own, residual_);
    for (Eigen::Index j = 0; j <= i; ++j) gram(i, j) = gram(j, i) = inner(own, group[static_cast<size_t>(j)]);
    seen = seen && gram(i, i) - fitted.col(i).squaredNorm() > kNotSeen * gram(i, i);
  }
  gram -= fitted.transpose() * fitted;
  if (!seen) return out;
  out.value = gram.ldlt().solve(moment);
  out.chi2 = out.value.dot(moment);
  out.std = gram.diagonal().cwiseSqrt().cwiseInverse();
  return out;
}

Eigen::MatrixXd Projection::free_gram(const Place& place, const std::vector<const Spectra*>& list, const Products& p,
                                      Eigen::Index first, Eigen::Index count) const {
  const auto fitted = p.fitted.middleCols(first, count);
  Eigen::MatrixXd gram = -fitted.transpose() * fitted;
  const auto column = [&](Eigen::Index i) -> const Spectra& { return *list[static_cast<size_t>(first + i)]; };
  for (Eigen::Index i = 0; i < count; ++i) {
    gram(i, i) += p.square[first + i];
    for (Eigen::Index j = 0; j < i; ++j) {
      const double both = inner(place, column(i), column(j));
      gram(i, j) += both, gram(j, i) += both;
    }
  }
  return gram;
}

}  // namespace diagnosis
