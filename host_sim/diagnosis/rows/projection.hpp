// The normal equations of a fit, and what a further column has in common with them.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "rows.hpp"

namespace diagnosis {

using Spectra = std::vector<Spectrum>;  // per record

// A fitted column: a force on a place (terms that share a coefficient are one).
struct FittedColumn {
  Place place;
  std::shared_ptr<const Spectra> spectra;
};

class Projection {
 public:
  // Fits the columns to a target; `residual` is what is left of it.
  Projection(std::shared_ptr<const Weights> weights, std::vector<FittedColumn> columns,
             const std::vector<Balance>& target);
  const std::vector<Balance>& residual() const { return residual_; }
  Eigen::Index count() const { return value_.size(); }
  double value(Eigen::Index i) const { return value_[i]; }
  double std(Eigen::Index i) const { return scale_[i] * inverse_.row(i).norm(); }
  double chi2() const;  // weighted square of the residual

  // Of columns at one place: with the orthonormalised fitted columns (fitted x columns), with the residual, with themselves.
  struct Products {
    Eigen::MatrixXd fitted;
    Eigen::VectorXd residual, square;
  };
  Products products(const Place& place, const std::vector<const Spectra*>& columns) const;
  // Of `count` of these columns, from `first` on: the Gram matrix of what the fitted columns cannot make of them.
  Eigen::MatrixXd free_gram(const Place& place, const std::vector<const Spectra*>& columns, const Products& products,
                            Eigen::Index first, Eigen::Index count) const;
  // What disturbances that act on every DOF, one balance per record each, explain together beside the fitted columns. A group
  // of which the fitted columns can make a member explains nothing.
  struct Explained {
    double chi2 = 0;
    Eigen::VectorXd value, std;
  };
  Explained explained(const std::vector<std::vector<Balance>>& group) const;
  // By how much the value of fitted column i falls per unit of a further column with these products.
  double answer(Eigen::Index i, const Eigen::VectorXd& fitted) const { return scale_[i] * inverse_.row(i).dot(fitted); }

 private:
  // A record seen from a place: the fitted columns pulled to it and last the residual, real and imaginary parts in turn;
  // the place's own weight per bin.
  struct View {
    Eigen::MatrixXd pulled;
    Series weight;
  };
  std::vector<View> fitted_from(const Place& place) const;  // the residual's column left open
  void add_residual(const Place& place, std::vector<View>& views) const;
  const std::vector<View>& seen_from(const Place& place) const;
  double inner(const Place& place, const Spectra& a, const Spectra& b) const;
  double inner(const std::vector<Balance>& a, const std::vector<Balance>& b) const;
  Eigen::MatrixXd gram() const;
  Eigen::VectorXd moments(const std::vector<Balance>& balance) const;
  void factorise(Eigen::MatrixXd gram);

  std::shared_ptr<const Weights> weights_;
  std::vector<FittedColumn> columns_;
  std::vector<Balance> residual_;
  Eigen::VectorXd scale_, value_;
  Eigen::MatrixXd inverse_;  // of the triangular factor R of the scaled columns' normal matrix R' R
  mutable std::map<Place, std::vector<View>> views_;
};

}  // namespace diagnosis
