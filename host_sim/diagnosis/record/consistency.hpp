// Whether a DOF's displacement, velocity and acceleration are one motion seen three times.
#pragma once
#include <cmath>

#include "motion.hpp"

namespace diagnosis {

// Fourier rows of one DOF's channels with the common motion projected out, whitened.
class Consistency {
 public:
  Consistency(const FusedRecord& f, size_t dof) : f_(f), s_(f.spectra[dof]) {
    first_ = f.first_beyond(f.slow_Hz);
    energy_ = f.outer.weight.squaredNorm();
    motion_ = Spectrum::Zero(f.last_bin + 1);
    for (Eigen::Index i = first_; i <= f.last_bin; ++i) {
      Complex sum = 0;
      for (size_t q = 0; q < 3; ++q)
        if (s_.measured[q]) sum += std::conj(derivative(f.omega(i), static_cast<int>(q))) * s_.z[q][i] / s_.noise[q][i];
      motion_[i] = sum / information(i);
    }
  }
  Series residual() const {
    return rows([&](Eigen::Index i, size_t q) { return s_.z[q][i]; });
  }
  // Row of a disturbance of one channel.
  template <typename Value>
  Series disturbance(size_t channel, Value value) const {
    return rows([&](Eigen::Index i, size_t q) { return q == channel ? value(i) : Complex(0, 0); });
  }
  // What the rows make of any disturbance: value(bin, quantity).
  template <typename Value>
  Series rows(Value value) const {
    Series out = Series::Zero(6 * (f_.last_bin + 1 - first_));
    for (Eigen::Index i = first_; i <= f_.last_bin; ++i) {
      Complex common = 0;
      for (size_t q = 0; q < 3; ++q)
        if (s_.measured[q])
          common += std::conj(derivative(f_.omega(i), static_cast<int>(q))) * value(i, q) / s_.noise[q][i];
      common /= information(i);
      for (size_t q = 0; q < 3; ++q) {
        if (!s_.measured[q]) continue;
        const Complex left = (value(i, q) - derivative(f_.omega(i), static_cast<int>(q)) * common) *
                             std::sqrt(2 / (s_.noise[q][i] * energy_));
        const Eigen::Index at = 6 * (i - first_) + 2 * static_cast<Eigen::Index>(q);
        out[at] = left.real(), out[at + 1] = left.imag();
      }
    }
    return out;
  }
  Complex seen(Eigen::Index i, size_t q) const { return derivative(f_.omega(i), static_cast<int>(q)) * motion_[i]; }
  double dof() const { return 2.0 * static_cast<double>((f_.last_bin + 1 - first_) * (s_.count() - 1)); }

 private:
  double information(Eigen::Index i) const {
    double sum = 0;
    for (size_t q = 0; q < 3; ++q)
      if (s_.measured[q]) sum += std::norm(derivative(f_.omega(i), static_cast<int>(q))) / s_.noise[q][i];
    return sum;
  }
  const FusedRecord& f_;
  const DofSpectra& s_;
  Spectrum motion_;
  Eigen::Index first_ = 0;
  double energy_ = 1;
};

}  // namespace diagnosis
