// What the rows of one record weigh: per bin the inverse L of the covariance of the equation errors (DOFs x DOFs), seen
// from the places where forces act. For a force s (one spectrum) on place p and another t on q the whitened rows' inner
// product is Re sum conj(s) (p' L q) t: one product per bin, however many DOFs there are.
#pragma once
#include <vector>

#include "fourier.hpp"

namespace diagnosis {

// Where a force acts: with + on one DOF (index from 0), with - on another; -1: on none (ground, base).
struct Place {
  int plus = -1, minus = -1;
  bool operator<(const Place& o) const { return plus != o.plus ? plus < o.plus : minus < o.minus; }
};

// Covariances of a bin: as large as the largest rig, without a heap.
constexpr int kMostDofs = 16;
using SmallMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostDofs, kMostDofs>;

using Balance = Eigen::MatrixXcd;  // bins x DOFs: the forces on each DOF

// Adds factor times a force on a place.
void act(Balance& balance, const Place& place, const Spectrum& force, double factor);

struct Tone {
  double hertz = 0, gain = 0;
  int dof = 0;
};

class Information {
 public:
  Information(Eigen::Index bins, Eigen::Index dofs);
  // The weights of a bin from its covariance (Hermitian; kept from being singular). Returns the logarithm of its determinant.
  double set(Eigen::Index bin, const SmallMatrix& covariance);
  Spectrum between(const Place& p, const Place& q) const;          // p' L q per bin
  Series weight(const Place& p) const;                             // p' L p per bin
  Spectrum pulled(const Place& p, const Balance& balance) const;   // p' L balance per bin
  Series power(const Balance& balance) const;                      // balance' L balance per bin: its whitened square
  Eigen::Index bins() const { return bins_; }

 private:
  const Spectrum& at(int row, int column) const { return entries_[static_cast<size_t>(row * dofs_ + column)]; }
  Eigen::Index bins_ = 0;
  int dofs_ = 0;
  std::vector<Spectrum> entries_;  // row by row
};

}  // namespace diagnosis
