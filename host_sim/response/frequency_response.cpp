#include "host_sim/response/frequency_response.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace host_sim {
namespace {

// The windowed spectrum of one segment.
class Transform {
 public:
  explicit Transform(size_t length)
      : length_(length),
        in_(fftw_alloc_real(length)),
        out_(fftw_alloc_complex(length / 2 + 1)),
        // FFTW_ESTIMATE times nothing, so the same plan, and the same bits, come out every time.
        plan_(fftw_plan_dft_r2c_1d(static_cast<int>(length), in_, out_, FFTW_ESTIMATE)) {}
  ~Transform() {
    fftw_destroy_plan(plan_);
    fftw_free(in_);
    fftw_free(out_);
  }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  void run(const double* values) {
    double mean = 0.0;
    const double n = static_cast<double>(length_);
    for (size_t i = 0; i < length_; ++i) mean += values[i] / n;
    for (size_t i = 0; i < length_; ++i)
      in_[i] = (values[i] - mean) * (0.5 - 0.5 * std::cos(2.0 * M_PI * static_cast<double>(i) / n));
    fftw_execute(plan_);
  }
  std::complex<double> bin(size_t k) const { return {out_[k][0], out_[k][1]}; }

 private:
  size_t length_;
  double* in_;
  fftw_complex* out_;
  fftw_plan plan_;
};

}  // namespace

size_t response_segment(size_t shortest_record) {
  size_t length = 8192;
  while (length > 64 && shortest_record < 4 * length + length / 2) length /= 2;
  return shortest_record < length ? 0 : length;
}

FrequencyResponse frequency_response(const std::vector<SignalPair>& records, double sample_period_s, size_t segment) {
  FrequencyResponse result;
  const size_t bins = segment / 2 + 1;
  std::vector<double> input_power(bins, 0.0), output_power(bins, 0.0);
  std::vector<std::complex<double>> cross(bins, 0.0);
  Transform input(segment), output(segment);
  for (const SignalPair& record : records)
    for (size_t first = 0; first + segment <= record.input->size(); first += segment / 2, ++result.segments) {
      input.run(record.input->data() + first);
      output.run(record.output->data() + first);
      for (size_t k = 0; k < bins; ++k) {
        input_power[k] += std::norm(input.bin(k));
        output_power[k] += std::norm(output.bin(k));
        cross[k] += std::conj(input.bin(k)) * output.bin(k);
      }
    }
  for (size_t k = 1; k < bins; ++k) {
    const double both = input_power[k] * output_power[k];
    result.frequency_Hz.push_back(static_cast<double>(k) / (static_cast<double>(segment) * sample_period_s));
    result.response.push_back(input_power[k] > 0.0 ? cross[k] / input_power[k] : 0.0);
    result.coherence.push_back(both > 0.0 ? std::min(1.0, std::norm(cross[k]) / both) : 0.0);
  }
  return result;
}

}  // namespace host_sim
