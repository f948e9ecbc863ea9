#include "hal/rig_file/recorded/shared_noise.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

void high_pass(const CoreConfiguration& c, int node, int q, std::vector<double>& input) {
  const int integrations = c.signals[node][q].integrations;
  const bool integrates_first = integrations == 1 && q == static_cast<int>(firmware::Quantity::kDisplacement);
  const double leak = std::ldexp(1.0, -c.high_pass_shift);
  const int from = integrates_first ? 0 : c.high_pass_order - integrations;
  for (int s = 0; s < c.high_pass_order; ++s) {
    const bool integrates = s >= from && s < from + integrations;
    double state = 0.0, previous = s == 0 && !input.empty() ? input[0] : 0.0;
    if (integrates && s == 0 && !input.empty()) input[0] *= 0.5;
    for (double& value : input) {
      state += value - (integrates ? 0.0 : previous) - state * leak;
      previous = value;
      value = integrates ? state * std::ldexp(1.0, firmware::kIntegrationExtraBits - c.high_pass_shift) : state;
    }
  }
  for (double& value : input) value = std::ldexp(value, -c.signals[node][q].dropped_bits);
}

namespace {

constexpr int kF = 0, kX = 1, kV = 2, kA = 3;

// Responses of a node's signals to one code of one of its channels at count / 4, SI units.
std::vector<double> response(const CoreConfiguration& c, int node, int q, int channel, size_t count) {
  const SignalConfiguration& signal = c.signals[node][q];
  std::vector<double> out(count, 0.0), code(count, 0.0);
  const double unit = to_double(signal.unit_per_code) * std::ldexp(1.0, -signal.shift);
  const long half = signal.half_length, length = static_cast<long>(count);
  code[count / 4] = 1.0;
  const auto filtered = [&](const auto& tap, long n) {
    double sum = 0.0;
    for (long k = -half; k <= half; ++k)
      if (n + k >= 0 && n + k < length) sum += tap[k + half].raw * code[static_cast<size_t>(n + k)];
    return sum;
  };
  const bool fused = q == kV && c.fusion[node].used;
  if (!fused) {
    if (channel != signal.source) return out;
    high_pass(c, node, q, code);
    const bool plain = half == 0 && signal.tap[0].raw == 0;
    for (long n = 0; n < length; ++n)
      out[static_cast<size_t>(n)] =
          plain ? to_double(signal.unit_per_code) * code[static_cast<size_t>(n)] : unit * filtered(signal.tap, n);
    return out;
  }
  const double keep = 1.0 - std::ldexp(1.0, -c.fusion[node].leak_shift);
  double once = 0.0, twice = 0.0, before = 0.0;
  for (long n = 0; n < length; ++n) {
    const double slope = channel == kX ? filtered(signal.tap, n) : 0.0;
    const double step = channel == kA ? filtered(c.fusion[node].step_tap, n) : 0.0;
    const double last = once;
    once = keep * once + step - (slope - before);
    twice = keep * twice + once - last;
    before = slope;
    out[static_cast<size_t>(n)] = unit * (slope + twice);
  }
  return out;
}

size_t response_samples(const CoreConfiguration& c, int node) {
  size_t count = 256;
  if (c.fusion[node].used) count = size_t{64} << c.fusion[node].leak_shift;
  if (c.high_pass_order > 0) count = std::max(count, size_t{16} << c.high_pass_shift);
  return count;
}

using Responses = std::vector<double>[kQuantities];

// Mean products of noise in the weights of the energy equations with that in the signals; with: `of` after the noise's own colour.
void add_to_energies(const CoreConfiguration& c, int node, double variance, const Responses& of, const Responses& with,
                     double (&shared)[3][kQuantities]) {
  if (!c.signals[node][kV].available) return;
  for (size_t n = 2; n + 2 < of[kV].size(); ++n) {
    const auto around = [&](int q) {
      return (4.0 * (of[q][n - 1] + of[q][n + 1]) - of[q][n - 2] - of[q][n + 2]) / 6.0;
    };
    for (int q = kX; q <= kA; ++q) {
      shared[0][q] += variance * of[kV][n] * with[q][n];
      shared[1][q] += variance * around(kV) * with[q][n];
      shared[2][q] += variance * around(kX) * with[q][n];
    }
  }
}

// The same for the instruments of the score tests (firmware/warrant/motion/neighbours.hpp).
double between_neighbours(const std::vector<double>& v, size_t n) {
  return (54 * (v[n - 1] + v[n + 1]) + 39 * (v[n - 2] + v[n + 2]) + 14 * (v[n - 3] + v[n + 3]) -
          21 * (v[n - 4] + v[n + 4])) /
         172;
}
double neighbours_slope(const std::vector<double>& v, size_t n) {
  return (v[n + 1] - v[n - 1] + 2 * (v[n + 2] - v[n - 2]) + 3 * (v[n + 3] - v[n - 3]) + 4 * (v[n + 4] - v[n - 4])) / 60;
}
void add_to_probes(double variance, const Responses& of, const Responses& with,
                   double (&shared)[firmware::kMotionProbeWeights][3]) {
  for (size_t n = 4; n + 4 < of[kX].size(); ++n) {
    const double weight[firmware::kMotionProbeWeights] = {between_neighbours(of[kX], n), between_neighbours(of[kV], n),
                                                          between_neighbours(of[kA], n), neighbours_slope(of[kA], n)};
    for (int w = 0; w < firmware::kMotionProbeWeights; ++w)
      for (int q = kX; q <= kA; ++q) shared[w][q - kX] += variance * weight[w] * with[q][n];
  }
}

// The response to noise of unit variance instead of to one code: sum of its correlation over lags times the response.
std::vector<double> coloured(const std::vector<double>& response, const ChannelNoise& noise) {
  if (noise.white()) return response;
  std::vector<double> out = response;
  if (!noise.correlation.empty()) {
    for (size_t n = 0; n < out.size(); ++n)
      for (size_t lag = 1; lag < noise.correlation.size(); ++lag) {
        if (n >= lag) out[n] += noise.correlation[lag] * response[n - lag];
        if (n + lag < out.size()) out[n] += noise.correlation[lag] * response[n + lag];
      }
    return out;
  }
  for (size_t n = 1; n < out.size(); ++n) out[n] += noise.pole * out[n - 1];
  double after = 0.0;
  for (size_t n = out.size(); n-- > 0;) {
    const double next = noise.pole * (after + (n + 1 < out.size() ? response[n + 1] : 0.0));
    out[n] += next;
    after = next;
  }
  return out;
}

uint16_t per_mille(double doubtful, double sum) {
  return static_cast<uint16_t>(sum > 0.0 ? std::lround(std::min(1000.0 * doubtful / sum, 65535.0)) : 0);
}

// Of one node, summed over its channels.
struct Products {
  double energies[3][kQuantities] = {}, probes[firmware::kMotionProbeWeights][3] = {};
  double size = 0, doubtful = 0;  // of the channels' noise in the velocity, where they have any
  void add(const CoreConfiguration& c, int node, int channel, const ChannelNoise& noise, size_t count) {
    Responses of, with;
    for (int q = kX; q <= kA; ++q) {
      of[q] = c.signals[node][q].available ? response(c, node, q, channel, count) : std::vector<double>(count, 0.0);
      with[q] = coloured(of[q], noise);
    }
    const double variance = noise.deviation * noise.deviation;
    add_to_energies(c, node, variance, of, with, energies);
    add_to_probes(variance, of, with, probes);
    double part = 0;
    for (size_t n = 0; n < count; ++n) part += variance * of[kV][n] * with[kV][n];
    size += std::fabs(part);
    doubtful += noise.doubt * std::fabs(part);
  }
};

void add_force(CoreConfiguration& c, int node, const ChannelNoise& noise, size_t count) {
  const std::vector<double> force = response(c, node, kF, kF, count), with = coloured(force, noise);
  double sum = 0.0;
  for (size_t n = 4; n + 4 < count; ++n) sum += between_neighbours(force, n) * with[n];
  c.probe_noise[node].force = to_scaled(noise.deviation * noise.deviation * sum);
  c.force_noise_doubt[node] = per_mille(noise.doubt, 1.0);
}

}  // namespace

void find_shared_noise(CoreConfiguration& c, const SignalRanges& ranges) {
  for (int node = 0; node < firmware::kMaxNodes; ++node) {
    const size_t count = response_samples(c, node);
    Products products;
    for (const int channel : {kF, kX, kV, kA}) {
      if (!c.channels[node][channel].present) continue;
      const ChannelNoise& noise = ranges.noise[node][channel];
      if (!(noise.deviation > 0.0)) {
        c.noise_unknown = true;
      } else if (channel == kF) {
        add_force(c, node, noise, count);
      } else {
        products.add(c, node, channel, noise, count);
      }
    }
    c.shares_probe_noise = true;
    for (int w = 0; w < 3; ++w)
      for (int q = kX; q <= kA; ++q) c.shared_noise[node][w][q] = to_scaled(products.energies[w][q]);
    for (int w = 0; w < firmware::kMotionProbeWeights; ++w)
      for (int q = 0; q < 3; ++q) c.probe_noise[node].motion[w][q] = to_scaled(products.probes[w][q]);
    c.motion_noise_doubt[node] = per_mille(products.doubtful, products.size);
  }
}

}  // namespace rig_file
