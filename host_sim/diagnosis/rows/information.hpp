// What the rows of one record weigh: per bin the inverse L of the covariance of the equation errors (DOFs x DOFs), seen
// from the places where forces act. For a force s (one spectrum) on place p and another t on q the whitened rows' inner
// product is Re sum conj(s) (p' L q) t: one product per bin, however many DOFs there are.
#pragma once
#include <vector>

#include "../record/fourier.hpp"
#include "../terms/terms.hpp"

namespace diagnosis {

// A Hermitian matrix per bin, entry by entry over all bins: the lower triangle, (0,0) (1,0) (1,1) (2,0) ...
using Triangle = std::vector<Spectrum>;
inline size_t in_triangle(Eigen::Index row, Eigen::Index column) {
  return static_cast<size_t>(row * (row + 1) / 2 + column);
}

using Balance = Eigen::MatrixXcd;  // bins x DOFs: the forces on each DOF

// Adds factor times a force on a place.
void act(Balance& balance, const Place& place, const Spectrum& force, double factor);

// Adds a value on a place to a symmetric matrix over the DOFs.
void act(Eigen::MatrixXd& matrix, const Place& place, double value);

struct Tone {
  double hertz = 0, gain = 0;
  int dof = 0;
};

class Information {
 public:
  // Inverts the covariance of every bin (kept from being singular).
  Information(Eigen::Index dofs, Triangle covariance);
  double log_determinant() const { return log_determinant_; }     // of the covariances, summed over the bins
  Spectrum between(const Place& p, const Place& q) const;         // p' L q per bin
  Series weight(const Place& p) const;                            // p' L p per bin
  Spectrum pulled(const Place& p, const Balance& balance) const;  // p' L balance per bin
  Series power(const Balance& balance) const;                     // balance' L balance per bin: its whitened square
  Eigen::Index bins() const { return bins_; }

 private:
  const Spectrum& at(Eigen::Index row, Eigen::Index column) const {
    return entries_[static_cast<size_t>(row * dofs_ + column)];
  }
  Eigen::Index bins_ = 0, dofs_ = 0;
  double log_determinant_ = 0;
  std::vector<Spectrum> entries_;  // row by row
};

}  // namespace diagnosis
