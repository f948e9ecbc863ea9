// Frequency response and coherence of a pair of signals (Welch's averages: Hann windows, half overlap).
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace host_sim {

struct FrequencyResponse {
  std::vector<double> frequency_Hz;            // from the first bin above 0 to half the sampling rate
  std::vector<std::complex<double>> response;  // output per input, units of the two (the H1 estimate S_xy / S_xx)
  std::vector<double> coherence;               // |S_xy|^2 / (S_xx S_yy), 0 to 1
  size_t segments = 0;                         // averaged; with one the coherence is 1 whatever the signals are
};

struct SignalPair {
  const std::vector<double>* input;   // of one length
  const std::vector<double>* output;  // with it
};

// The longest power of two of which the shortest record holds 8 (4.5 lengths at half overlap), 64 to 8192 samples;
// 0 where not even 64 fit once.
size_t response_segment(size_t shortest_record);

// The mean of every segment is removed; the averages run over all segments of all records. segment: even, at least 2.
FrequencyResponse frequency_response(const std::vector<SignalPair>& records, double sample_period_s, size_t segment);

}  // namespace host_sim
