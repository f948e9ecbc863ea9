// Many cosines on evenly spaced lines, summed at evenly spaced times: by two fast transforms instead of line by line.
#pragma once
#include <complex>
#include <vector>

namespace host_sim {

// sum[n] = sum over k of amplitude[k] exp(2 pi i (first + k spacing) n) for 0 <= n < count; first and spacing in turns a step.
// Chirp transform (Bluestein, IEEE Trans. Audio Electroacoust. 18, 1970): with k n = (k^2 + n^2 - (n - k)^2) / 2 the sum is a
// convolution. Off by some 1e-14 of the root of the sum of squares of the amplitudes.
class LineSum {
 public:
  LineSum(size_t lines, size_t count, double first_turns, double spacing_turns);
  std::vector<std::complex<double>> of(const std::vector<std::complex<double>>& amplitude) const;

 private:
  struct Parts {  // real and imaginary parts beside each other, so that the compiler can use vectors
    std::vector<double> re, im;
  };
  std::complex<double> chirp(double first_turns, size_t m) const;  // exp(2 pi i (first m + spacing m^2 / 2))
  void transform(Parts& of) const;                                 // forward; its result in bit-reversed order
  void transform_back(Parts& of) const;                            // from there, times the length

  size_t lines_, count_, length_ = 1;
  double half_spacing_turns_;
  std::vector<std::complex<double>> chirp_, chirp_from_first_;
  Parts turn_;    // exp(-pi i j / half) at half + j, for every half < length
  Parts kernel_;  // transformed
};

}  // namespace host_sim
