#include "hal/rig_file/signals/largest.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/recorded/shared_noise.hpp"
#include "hal/rig_file/recorded/slowest_motion.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::SignalConfiguration;

// The fused velocity over one record, in double.
double largest_fused(const CoreConfiguration& c, int node, const std::vector<firmware::RawSample>& record) {
  const SignalConfiguration& signal = c.signals[node][kV];
  const size_t length = 2u * signal.half_length + 1u;
  double once = 0.0, twice = 0.0, before = 0.0, largest = 0.0;
  for (size_t n = 0; n + length <= record.size(); ++n) {
    double slope = 0.0, step = 0.0;
    for (size_t k = 0; k < length; ++k) {
      slope += signal.tap[k].raw * static_cast<double>(record[n + k].code[node][kX] - c.channels[node][kX].offset_code);
      step += c.fusion[node].step_tap[k].raw *
              static_cast<double>(record[n + k].code[node][kA] - c.channels[node][kA].offset_code);
    }
    const double last = once;
    const double keep = 1.0 - std::ldexp(1.0, -c.fusion[node].leak_shift);
    once = keep * once + step - (n == 0 ? 0.0 : slope - before);
    twice = keep * twice + once - last;
    before = slope;
    largest = std::max(largest, std::fabs(slope + twice));
  }
  return std::ldexp(largest, -signal.shift) * to_double(signal.unit_per_code);
}

}  // namespace

double largest_value(const CoreConfiguration& c, int node, int q, const std::vector<firmware::RawSample>& record) {
  const SignalConfiguration& signal = c.signals[node][q];
  if (q == kV && c.fusion[node].used) return largest_fused(c, node, record);
  const int offset = c.channels[node][signal.source].offset_code;
  std::vector<double> input(record.size());
  for (size_t n = 0; n < record.size(); ++n) input[n] = record[n].code[node][signal.source] - offset;
  high_pass(c, node, q, input);
  double largest = 0.0;
  const size_t length = 2u * signal.half_length + 1u;
  for (size_t n = 0; n + length <= input.size(); ++n) {
    double sum = 0.0;
    for (size_t k = 0; k < length; ++k) sum += signal.tap[k].raw * input[n + k];
    largest = std::max(largest, std::fabs(sum));
  }
  return std::ldexp(largest, -signal.shift) * to_double(signal.unit_per_code);
}

}  // namespace rig_file
