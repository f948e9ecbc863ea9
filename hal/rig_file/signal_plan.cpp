#include "hal/rig_file/signal_plan.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/filter_design.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

constexpr int kF = 0, kX = 1, kV = 2, kA = 3;
// Corner for one integration and for two; the nearest power of two is taken. Two need the higher one: noise and the start of
// a level grow with the square of the time that they are remembered.
constexpr double kHighPass_Hz = 0.2, kDoubleHighPass_Hz = 1.0;
constexpr double kSignalPeak = 1 << 22;

// One signal as real numbers: out = sum of h * input, input = codes or their integrated codes.
struct Design {
  Impulse impulse;           // SI units out per code in
  double largest_bound = 0;  // in SI units, from full scale and band
};

class Plan {
 public:
  explicit Plan(CoreConfiguration& configuration)
      : c_(configuration), period_s_(to_double(configuration.sample_period_s)) {}

  void choose_sources() {
    for (int node = 0; node < firmware::kMaxNodes; ++node) {
      for (int q = 0; q < kQuantities; ++q) c_.signals[node][q] = SignalConfiguration{};
      const bool is_base = node == firmware::kBaseNode;
      if (node >= c_.dof_count && !(is_base && c_.base_present)) continue;
      choose_node(node, is_base);
    }
    int integrations = 0;
    for (auto& node : c_.signals)
      for (SignalConfiguration& signal : node) integrations = std::max<int>(integrations, signal.integrations);
    c_.high_pass_order = static_cast<uint8_t>(integrations == 0 ? 0 : integrations + 1);
    const double corner_Hz = integrations > 1 ? kDoubleHighPass_Hz : kHighPass_Hz;
    const double shift = std::log2(1.0 / (2.0 * M_PI * corner_Hz * period_s_));
    c_.high_pass_shift = static_cast<uint8_t>(std::clamp(static_cast<int>(std::lround(shift)), 7, 12));
  }

  bool differentiates() const {
    return any([&](int node, int q) { return derivatives(node, q) > 0; });
  }
  bool delayed() const {
    return any([&](int node, int q) { return c_.channels[node][c_.signals[node][q].source].delay_ns != 0; });
  }
  bool filtered() const { return differentiates() || delayed() || c_.high_pass_order > 0; }

  Design design(int node, int q) const {
    const SignalConfiguration& signal = c_.signals[node][q];
    const firmware::ChannelConfiguration& channel = c_.channels[node][signal.source];
    const double advance = channel.delay_ns * 1e-9 / period_s_;
    if (std::fabs(advance) > 3.0)
      throw RigFileError("rig", 0, "delay of a channel of " + node_name(node),
                         std::to_string(channel.delay_ns / 1000) + " us, expected at most 3 sample periods");
    Design result;
    result.impulse = differentiates() ? low_pass(advance) : shifted_all_pass(advance);
    const double unit = to_double(channel.unit_per_code);
    double gain = unit;
    result.largest_bound = unit * 0.5 * (static_cast<double>(channel.highest_code) - channel.lowest_code);
    const int d = derivatives(node, q);
    if (d > 0) result.impulse = convolve(result.impulse, d == 1 ? first_difference() : second_difference());
    for (int i = 0; i < d; ++i) {
      gain /= period_s_;
      result.largest_bound *= 0.63 / period_s_;
    }
    for (int i = 0; i < signal.integrations; ++i) {
      result.impulse = convolve(result.impulse, sum_to_integral());
      gain *= period_s_ * std::ldexp(1.0, c_.high_pass_shift - firmware::kIntegrationExtraBits);
      result.largest_bound /= 2.0 * M_PI;
    }
    for (double& tap : result.impulse) tap *= gain;
    return result;
  }

  // Integer taps and the unit; the largest value gets 22 bits.
  void quantise(int node, int q, double largest) {
    SignalConfiguration& signal = c_.signals[node][q];
    const Design made = design(node, q);
    const double peak = largest > 0.0 ? largest : made.largest_bound;
    const double unit = std::exp2(std::ceil(std::log2(peak / kSignalPeak)));
    double biggest = 0.0;
    for (double tap : made.impulse) biggest = std::max(biggest, std::fabs(tap / unit));
    const int bits = signal.integrations > 0 ? 25 : 30;  // inputs of 31 or 24 bits, 33 taps: the sum stays below 2^61
    const int shift = std::clamp(bits - 1 - std::ilogb(biggest), 0, 62);
    signal.shift = static_cast<uint8_t>(shift);
    const int half = static_cast<int>(made.impulse.size() / 2);
    signal.half_length = static_cast<uint8_t>(half);
    for (int k = 0; k <= 2 * half; ++k)
      signal.tap[k].raw =
          static_cast<int32_t>(std::lround(std::ldexp(made.impulse[static_cast<size_t>(k)] / unit, shift)));
    signal.unit_per_code = to_scaled(unit);
  }

 private:
  static std::string node_name(int node) {
    return node == firmware::kBaseNode ? "the base" : "DOF " + std::to_string(node + 1);
  }
  template <typename Test>
  bool any(Test test) const {
    for (int node = 0; node < firmware::kMaxNodes; ++node)
      for (int q = 0; q < kQuantities; ++q)
        if (c_.signals[node][q].available && test(node, q)) return true;
    return false;
  }
  int derivatives(int node, int q) const {
    const SignalConfiguration& signal = c_.signals[node][q];
    return signal.derived && signal.source < q ? q - signal.source : 0;
  }
  bool displacement_needed(int node) const {
    for (int t = 0; t < c_.term_count; ++t) {
      const firmware::Term& term = c_.terms[t];
      if (term.kind == firmware::TermKind::kMass || term.kind == firmware::TermKind::kViscous ||
          term.kind == firmware::TermKind::kCoulomb)
        continue;
      const firmware::LinkConfiguration& link = c_.links[term.place];
      if (link.node_a == node || link.node_b == node) return true;
    }
    return false;
  }
  bool mass_needed(int node) const {
    for (int t = 0; t < c_.term_count; ++t)
      if (c_.terms[t].kind == firmware::TermKind::kMass && c_.terms[t].place == node) return true;
    return false;
  }
  void take(int node, int q, int source) {
    SignalConfiguration& signal = c_.signals[node][q];
    signal.available = true;
    signal.source = static_cast<uint8_t>(source);
    signal.derived = source != q;
    signal.integrations = static_cast<uint8_t>(source > q ? source - q : 0);
    signal.unit_per_code = c_.channels[node][source].unit_per_code;
  }
  void choose_node(int node, bool is_base) {
    const auto measured = [&](int q) { return c_.channels[node][q].present; };
    if (measured(kF)) take(node, kF, kF);
    if (!measured(kX) && !measured(kV) && !measured(kA))
      throw RigFileError("rig", 0, "channels of " + node_name(node),
                         "no motion is measured, expected a displacement, velocity or acceleration channel");
    take(node, kV, measured(kV) ? kV : (measured(kX) ? kX : kA));
    if (measured(kX)) {
      take(node, kX, kX);
    } else if (displacement_needed(node)) {
      take(node, kX, measured(kV) ? kV : kA);
    }
    if (measured(kA)) {
      take(node, kA, kA);
    } else if (!is_base && mass_needed(node) && !measured(kV)) {
      take(node, kA, kX);
    }
  }

  CoreConfiguration& c_;
  double period_s_;
};

// The signals' values over one record, in double: as firmware/conditioning, without its rounding.
double largest_value(const CoreConfiguration& c, int node, int q, const std::vector<firmware::RawSample>& record) {
  const SignalConfiguration& signal = c.signals[node][q];
  const int offset = c.channels[node][signal.source].offset_code;
  const double leak = std::ldexp(1.0, -c.high_pass_shift);
  std::vector<double> input(record.size());
  for (size_t n = 0; n < record.size(); ++n) input[n] = record[n].code[node][signal.source] - offset;
  for (int s = 0; s < c.high_pass_order; ++s) {
    const bool difference = s < c.high_pass_order - signal.integrations;
    double state = 0.0, previous = s == 0 && !input.empty() ? input[0] : 0.0;
    for (double& value : input) {
      state += value - (difference ? previous : 0.0) - state * leak;
      previous = value;
      value = difference ? state : state * std::ldexp(1.0, firmware::kIntegrationExtraBits - c.high_pass_shift);
    }
  }
  double largest = 0.0;
  const size_t length = 2u * signal.half_length + 1u;
  for (size_t n = 0; n + length <= input.size(); ++n) {
    double sum = 0.0;
    for (size_t k = 0; k < length; ++k) sum += signal.tap[k].raw * input[n + k];
    largest = std::max(largest, std::fabs(sum));
  }
  return std::ldexp(largest, -signal.shift) * to_double(signal.unit_per_code);
}

}  // namespace

void plan_signals(CoreConfiguration& configuration, const SignalRanges& ranges) {
  Plan plan(configuration);
  plan.choose_sources();
  if (!plan.filtered()) return;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (configuration.signals[node][q].available) plan.quantise(node, q, ranges.largest[node][q]);
}

SignalRanges measure_ranges(const CoreConfiguration& planned,
                            const std::vector<std::vector<firmware::RawSample>>& records) {
  SignalRanges ranges;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) {
      const SignalConfiguration& signal = planned.signals[node][q];
      if (!signal.available || (signal.half_length == 0 && signal.tap[0].raw == 0)) continue;
      for (const auto& record : records)
        ranges.largest[node][q] = std::max(ranges.largest[node][q], largest_value(planned, node, q, record));
    }
  return ranges;
}

std::string describe_plan(const CoreConfiguration& planned) {
  static const char* const kNames[kQuantities] = {"force", "displacement", "velocity", "acceleration"};
  std::string text;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) {
      const SignalConfiguration& signal = planned.signals[node][q];
      if (!signal.available || !signal.derived) continue;
      text += text.empty() ? "" : "; ";
      text += std::string(kNames[q]) +
              (node == firmware::kBaseNode ? " of the base" : " of DOF " + std::to_string(node + 1)) +
              " derived from " + kNames[signal.source];
    }
  return text;
}

}  // namespace rig_file
