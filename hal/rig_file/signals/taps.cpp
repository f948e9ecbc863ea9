#include "hal/rig_file/signals/taps.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/filter_design.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signals/integral_bound.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::SignalConfiguration;

constexpr double kSignalPeak = 1 << 22;

// One signal as real numbers: out = sum of h * input, input = codes or their integrated codes.
struct Design {
  Impulse impulse;           // SI units out per code in
  double gain = 0;           // of it, at rest
  double largest_bound = 0;  // in SI units, from full scale and band; of an integral half of it
  int dropped_bits = 0;      // of the integrated codes
};

// The same response with zeros at both ends.
Impulse widened(const Impulse& impulse, size_t length) {
  Impulse wide(length, 0.0);
  std::copy(impulse.begin(), impulse.end(), wide.begin() + static_cast<long>((length - impulse.size()) / 2));
  return wide;
}

// Largest slope of a motion of unit size, per second: of a tenth of the sample rate, which the low-pass ends at, or of the fastest one.
double steepest(const CoreConfiguration& c, const SignalRanges& ranges) {
  const double band = 0.63 / to_double(c.sample_period_s);
  return ranges.fastest_Hz > 0.0 ? std::min(band, 2.0 * M_PI * ranges.fastest_Hz) : band;
}

// Friction takes its sign from an integral of its own, one high-pass section and an eighth of the corner: 2 / e of its time constant. Where
// that is more than motion of 1 Hz needs it may be cut off: a sign remains.
double sign_velocity_bound(const CoreConfiguration& c, double full_scale) {
  const double time_constant_s = std::ldexp(to_double(c.sample_period_s), c.high_pass_shift + 3);
  return full_scale * std::min(0.75 * time_constant_s, 2.0 / (2.0 * M_PI));
}

// The plan knows no motion that an integral cannot hold: what fills it is what the corner lets through. The bound is hard, so it has no
// bit to spare. Where a recording has told the largest value, the integrated codes are as large as that.
void bound_integral(const CoreConfiguration& c, const SignalRanges& ranges, int node, int q, Design& design) {
  constexpr double kHeld = 2147483000.0, kFilterEdges = 1.25;
  IntegralBound bound = integral_bound(c, node, q, design.impulse);
  if (q == kV) bound.signal = std::max(bound.signal, sign_velocity_bound(c, design.largest_bound));
  design.largest_bound = 0.5 * bound.signal * (1.0 + 1e-5);
  const double told = ranges.largest[node][q] / design.gain * kFilterEdges;
  const double integral = told > 0.0 ? std::min(told, bound.integral) : bound.integral;
  while (std::ldexp(integral, -design.dropped_bits) > kHeld) ++design.dropped_bits;
  for (double& tap : design.impulse) tap = std::ldexp(tap, design.dropped_bits);
}

Design design(const CoreConfiguration& c, const SignalRanges& ranges, int node, int q) {
  const SignalConfiguration& signal = c.signals[node][q];
  const firmware::ChannelConfiguration& channel = c.channels[node][signal.source];
  const double period_s = to_double(c.sample_period_s);
  const double advance = channel.delay_ns * 1e-9 / period_s;
  if (std::fabs(advance) > 3.0)
    throw RigFileError("rig", 0, "delay of a channel of " + node_name(node),
                       std::to_string(channel.delay_ns / 1000) + " us, expected at most 3 sample periods");
  Design result;
  result.impulse = differentiates(c) ? low_pass(advance, band(c, ranges)) : shifted_all_pass(advance);
  const double unit = to_double(channel.unit_per_code);
  result.gain = unit;
  result.largest_bound = unit * 0.5 * (static_cast<double>(channel.highest_code) - channel.lowest_code);
  const int d = fused(c, node, q) ? 1 : derivatives(c, node, q);
  if (d > 0)
    result.impulse =
        convolve(result.impulse, d == 1 ? first_difference(band(c, ranges)) : second_difference(band(c, ranges)));
  for (int i = 0; i < d; ++i) {
    result.gain /= period_s;
    result.largest_bound *= steepest(c, ranges);
  }
  // The rule over more samples wherever the history holds it and leaves room for the filter of friction's sign.
  const Band rule = differentiates(c) && signal.integrations > 1 ? Band::kTenth : Band::kWide;
  for (int i = 0; i < signal.integrations; ++i) {
    result.impulse = convolve(result.impulse, sum_to_integral(rule));
    result.gain *= period_s * std::ldexp(1.0, c.high_pass_shift - firmware::kIntegrationExtraBits);
  }
  for (double& tap : result.impulse) tap *= result.gain;
  if (signal.integrations > 0) bound_integral(c, ranges, node, q, result);
  return result;
}

// The step of the integral of a fused velocity's acceleration over one sample period, in units of `unit`.
Impulse integral_step(const CoreConfiguration& c, int node, double unit) {
  const firmware::ChannelConfiguration& channel = c.channels[node][kA];
  const double period_s = to_double(c.sample_period_s);
  Impulse step = convolve(shifted_all_pass(channel.delay_ns * 1e-9 / period_s), sum_to_integral());
  for (double& tap : step) tap *= to_double(channel.unit_per_code) * period_s / unit;
  return step;
}

// Integer taps and the unit; the largest value gets 22 bits.
void quantise(CoreConfiguration& c, const SignalRanges& ranges, int node, int q) {
  SignalConfiguration& signal = c.signals[node][q];
  Design made = design(c, ranges, node, q);
  const double largest = ranges.largest[node][q];
  const double peak = largest > 0.0 ? largest : made.largest_bound;
  double unit = std::exp2(std::ceil(std::log2(peak / kSignalPeak)));
  // What is neither slope nor integral has the codes of its channel at the least: where the rails of 24 bits only say that nobody has told
  // them, the converter may have 12.
  const bool measured = !signal.derived && !(largest > 0.0);
  if (measured) unit = std::min(unit, to_double(c.channels[node][q].unit_per_code));
  double biggest = 0.0;
  Impulse step;
  if (fused(c, node, q)) {
    step = integral_step(c, node, unit);
    const size_t length = std::max(made.impulse.size(), step.size());
    made.impulse = widened(made.impulse, length);
    step = widened(step, length);
  }
  for (double tap : made.impulse) biggest = std::max(biggest, std::fabs(tap / unit));
  // Inputs of 31 or 24 bits, 33 taps: the sum stays below 2^61. What keeps its channel's codes has the larger taps, with which a low-pass
  // is rounded from 32 bits on.
  const int bits = signal.integrations > 0 ? 25 : measured && !fused(c, node, q) ? 31 : 30;
  const int shift = std::clamp(bits - 1 - std::ilogb(biggest), 0, 62);
  signal.shift = static_cast<uint8_t>(shift);
  signal.dropped_bits = static_cast<uint8_t>(made.dropped_bits);
  const int half = static_cast<int>(made.impulse.size() / 2);
  signal.half_length = static_cast<uint8_t>(half);
  for (int k = 0; k <= 2 * half; ++k)
    signal.tap[k].raw =
        static_cast<int32_t>(std::lround(std::ldexp(made.impulse[static_cast<size_t>(k)] / unit, shift)));
  for (size_t k = 0; k < step.size(); ++k)
    c.fusion[node].step_tap[k].raw = static_cast<int32_t>(std::lround(std::ldexp(step[k], shift)));
  signal.unit_per_code = to_scaled(unit);
}

// The low-pass for friction's sign, as far as the history of the signals reaches.
void filter_signs(CoreConfiguration& c, const SignalRanges& ranges) {
  int longest = 0;
  for (const auto& node : c.signals)
    for (const SignalConfiguration& signal : node) longest = std::max<int>(longest, signal.half_length);
  if (!has_friction(c) || !differentiates(c) || 2 * longest + kLowPassHalf > 2 * firmware::kFilterHalf) return;
  static_assert(kLowPassHalf == firmware::kSignFilterHalf, "the same filter");
  const Impulse taps = low_pass(0.0, band(c, ranges));
  c.sign_half_length = kLowPassHalf;
  for (size_t k = 0; k < taps.size(); ++k)
    c.sign_tap[k].raw = static_cast<int32_t>(std::lround(std::ldexp(taps[k], firmware::PassedSign::kFractionBits)));
}

}  // namespace

void make_filters(CoreConfiguration& c, const SignalRanges& ranges) {
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < firmware::kQuantities; ++q)
      if (c.signals[node][q].available) quantise(c, ranges, node, q);
  filter_signs(c, ranges);
}

}  // namespace rig_file
