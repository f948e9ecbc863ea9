#include "host_sim/plant/instruments/line_sum.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fixed_point/wider_vectors.hpp"

namespace host_sim {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;

// The fraction of factor * m, both parts of the product kept: m^2 is a whole number of turns times 10^9.
double turns(double factor, double m) {
  const double product = factor * m, rest = std::fma(factor, m, -product);
  return product - std::floor(product) + rest;
}

}  // namespace

LineSum::LineSum(size_t lines, size_t count, double first_turns, double spacing_turns)
    : lines_(lines), count_(count), half_spacing_turns_(0.5 * spacing_turns) {
  for (size_t m = 0; m < std::max(lines, count); ++m) chirp_.push_back(chirp(0.0, m));
  for (size_t n = 0; n < count; ++n) chirp_from_first_.push_back(chirp(first_turns, n));
  while (length_ < lines + count) length_ *= 2;
  turn_.re.resize(length_);
  turn_.im.resize(length_);
  for (size_t half = length_ / 2; half >= 1; half /= 2)
    for (size_t j = 0; j < half; ++j) {
      const double angle = -0.5 * kTwoPi * static_cast<double>(j) / static_cast<double>(half);
      const bool longest = 2 * half == length_;
      turn_.re[half + j] = longest ? std::cos(angle) : turn_.re[2 * (half + j)];
      turn_.im[half + j] = longest ? std::sin(angle) : turn_.im[2 * (half + j)];
    }
  kernel_.re.assign(length_, 0.0);
  kernel_.im.assign(length_, 0.0);
  const auto put = [this](size_t place, size_t m) {
    const std::complex<double> back = std::conj(chirp_[m]);
    kernel_.re[place] = back.real(), kernel_.im[place] = back.imag();
  };
  for (size_t m = 0; m < count; ++m) put(m, m);
  for (size_t m = 1; m < lines; ++m) put(length_ - m, m);
  transform(kernel_);
}

std::complex<double> LineSum::chirp(double first_turns, size_t m) const {
  const double step = static_cast<double>(m);
  const double angle = kTwoPi * (turns(first_turns, step) + turns(half_spacing_turns_, step * step));
  return {std::cos(angle), std::sin(angle)};
}

std::vector<std::complex<double>> LineSum::of(const std::vector<std::complex<double>>& amplitude) const {
  Parts work{std::vector<double>(length_, 0.0), std::vector<double>(length_, 0.0)};
  for (size_t k = 0; k < lines_; ++k) {
    const std::complex<double> turned = amplitude[k] * chirp_[k];
    work.re[k] = turned.real();
    work.im[k] = turned.imag();
  }
  transform(work);
  for (size_t i = 0; i < length_; ++i) {
    const double re = work.re[i] * kernel_.re[i] - work.im[i] * kernel_.im[i];
    work.im[i] = work.re[i] * kernel_.im[i] + work.im[i] * kernel_.re[i];
    work.re[i] = re;
  }
  transform_back(work);
  std::vector<std::complex<double>> sum(count_);
  for (size_t n = 0; n < count_; ++n)
    sum[n] = std::complex<double>(work.re[n], work.im[n]) * chirp_from_first_[n] / static_cast<double>(length_);
  return sum;
}

FIRMWARE_WIDER_VECTORS void LineSum::transform(Parts& of) const {
  for (size_t half = length_ / 2; half >= 1; half /= 2)
    for (size_t begin = 0; begin < length_; begin += 2 * half) {
      double* __restrict a = &of.re[begin], * __restrict b = a + half;
      double* __restrict p = &of.im[begin], * __restrict q = p + half;
      const double* __restrict c = &turn_.re[half], * __restrict s = &turn_.im[half];
      for (size_t j = 0; j < half; ++j) {
        const double re = a[j] - b[j], im = p[j] - q[j];
        a[j] += b[j];
        p[j] += q[j];
        b[j] = re * c[j] - im * s[j];
        q[j] = re * s[j] + im * c[j];
      }
    }
}

FIRMWARE_WIDER_VECTORS void LineSum::transform_back(Parts& of) const {
  for (size_t half = 1; half < length_; half *= 2)
    for (size_t begin = 0; begin < length_; begin += 2 * half) {
      double* __restrict a = &of.re[begin], * __restrict b = a + half;
      double* __restrict p = &of.im[begin], * __restrict q = p + half;
      const double* __restrict c = &turn_.re[half], * __restrict s = &turn_.im[half];
      for (size_t j = 0; j < half; ++j) {
        const double re = b[j] * c[j] + q[j] * s[j], im = q[j] * c[j] - b[j] * s[j];
        b[j] = a[j] - re;
        q[j] = p[j] - im;
        a[j] += re;
        p[j] += im;
      }
    }
}

}  // namespace host_sim
