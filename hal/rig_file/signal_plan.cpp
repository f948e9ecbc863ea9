#include "hal/rig_file/signal_plan.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/filter_design.hpp"
#include "hal/rig_file/motion_band.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/shared_noise.hpp"
#include "hal/rig_file/slowest_motion.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

constexpr int kF = 0, kX = 1, kV = 2, kA = 3;
// Corner for one integration and for two; the nearest power of two is taken. Two need the higher one: noise and the start of
// a level grow with the square of the time that they are remembered. What drives a rig has little below the rig's own motion, and slow
// noise is left out from a higher corner on; a decay needs its first seconds, friction beside it and all.
constexpr double kHighPass_Hz = 0.2, kDrivenHighPass_Hz = 0.5, kDoubleHighPass_Hz = 1.0;
// The time constant of a corner that follows a fast motion up, in octaves of a period of the slowest motion. One integration has settled
// within one time constant (conditioning), so it may take eight periods. Two take 16 time constants: half a period. The corner is then a
// factor pi below the motion, and the velocity of friction's sign, whose corner is eight times lower, leads by 0.08 rad there: of
// drawn rigs one friction in nine was then outside its 95 % interval, up to 4 % off. With a whole period one in 20 is.
constexpr int kPeriodOfOne = 3, kPeriodOfTwo = -1, kPeriodOfTwoWithFriction = 0;
constexpr int kLeastHighPassShift = firmware::kIntegrationExtraBits, kMostHighPassShift = 12;
constexpr double kSignalPeak = 1 << 22;
// Time constant of a fusion: 16 to 1024 sample periods.
constexpr int kLeastLeak = 4, kMiddleLeak = 5, kMostLeak = 10;

// One signal as real numbers: out = sum of h * input, input = codes or their integrated codes.
struct Design {
  Impulse impulse;           // SI units out per code in
  double largest_bound = 0;  // in SI units, from full scale and band
};

// The same response with zeros at both ends.
Impulse widened(const Impulse& impulse, size_t length) {
  Impulse wide(length, 0.0);
  std::copy(impulse.begin(), impulse.end(), wide.begin() + static_cast<long>((length - impulse.size()) / 2));
  return wide;
}

class Plan {
 public:
  Plan(CoreConfiguration& configuration, const SignalRanges& ranges)
      : c_(configuration), ranges_(ranges), period_s_(to_double(configuration.sample_period_s)) {}

  // Displacement with acceleration is fused, unless another node needs a filter that all signals have to pass.
  void choose_sources() {
    choose_sources(true);
    if (differentiates() || c_.high_pass_order > 0) choose_sources(false);
  }
  void choose_sources(bool fuse) {
    fuse_ = fuse;
    for (int node = 0; node < firmware::kMaxNodes; ++node) {
      for (int q = 0; q < kQuantities; ++q) c_.signals[node][q] = SignalConfiguration{};
      c_.fusion[node] = firmware::FusionConfiguration{};
      const bool is_base = node == firmware::kBaseNode;
      if (node >= c_.dof_count && !(is_base && c_.base_present)) continue;
      choose_node(node, is_base);
    }
    const int integrations = most_integrations();
    c_.high_pass_order = static_cast<uint8_t>(integrations == 0 ? 0 : integrations + 1);
    const double once_Hz = driven() && !friction_without_acceleration() ? kDrivenHighPass_Hz : kHighPass_Hz;
    const double corner_Hz = integrations > 1 ? kDoubleHighPass_Hz : once_Hz;
    const double shift = std::log2(1.0 / (2.0 * M_PI * corner_Hz * period_s_));
    int nearest = std::clamp(static_cast<int>(std::lround(shift)), kLeastHighPassShift, kMostHighPassShift);
    if (ranges_.octaves_to_slowest_motion)
      nearest = std::clamp(*ranges_.octaves_to_slowest_motion + octaves_of_period(), kLeastHighPassShift, nearest);
    c_.high_pass_shift = static_cast<uint8_t>(nearest);
  }

  // Of a period of the slowest motion to the time constant of a corner that follows it.
  int octaves_of_period() const {
    if (most_integrations() < 2) return kPeriodOfOne;
    return has_friction() ? kPeriodOfTwoWithFriction : kPeriodOfTwo;
  }
  bool differentiates() const {
    return any([&](int node, int q) { return derivatives(node, q) > 0; });
  }
  bool delayed() const {
    return any([&](int node, int q) { return c_.channels[node][c_.signals[node][q].source].delay_ns != 0; });
  }
  bool fuses() const {
    return any([&](int node, int) { return c_.fusion[node].used; });
  }
  // A delayed channel's filter has no room for more.
  Band band() const { return ranges_.wide_band && differentiates() && !delayed() ? Band::kWide : Band::kTenth; }
  bool filtered() const { return differentiates() || delayed() || fuses() || c_.high_pass_order > 0; }

  Design design(int node, int q) const {
    const SignalConfiguration& signal = c_.signals[node][q];
    const firmware::ChannelConfiguration& channel = c_.channels[node][signal.source];
    const double advance = channel.delay_ns * 1e-9 / period_s_;
    if (std::fabs(advance) > 3.0)
      throw RigFileError("rig", 0, "delay of a channel of " + node_name(node),
                         std::to_string(channel.delay_ns / 1000) + " us, expected at most 3 sample periods");
    Design result;
    result.impulse = differentiates() ? low_pass(advance, band()) : shifted_all_pass(advance);
    const double unit = to_double(channel.unit_per_code);
    double gain = unit;
    result.largest_bound = unit * 0.5 * (static_cast<double>(channel.highest_code) - channel.lowest_code);
    const int d = fused(node, q) ? 1 : derivatives(node, q);
    if (d > 0) result.impulse = convolve(result.impulse, d == 1 ? first_difference(band()) : second_difference(band()));
    for (int i = 0; i < d; ++i) {
      gain /= period_s_;
      result.largest_bound *= 0.63 / period_s_;
    }
    // The rule over more samples wherever the history holds it and leaves room for the filter of friction's sign.
    const Band rule = differentiates() && signal.integrations > 1 ? Band::kTenth : Band::kWide;
    for (int i = 0; i < signal.integrations; ++i) {
      result.impulse = convolve(result.impulse, sum_to_integral(rule));
      gain *= period_s_ * std::ldexp(1.0, c_.high_pass_shift - firmware::kIntegrationExtraBits);
      result.largest_bound /= 2.0 * M_PI;
    }
    for (double& tap : result.impulse) tap *= gain;
    return result;
  }

  // The step of the integral of a fused velocity's acceleration over one sample period, in units of `unit`.
  Impulse integral_step(int node, double unit) const {
    const firmware::ChannelConfiguration& channel = c_.channels[node][kA];
    Impulse step = convolve(shifted_all_pass(channel.delay_ns * 1e-9 / period_s_), sum_to_integral());
    for (double& tap : step) tap *= to_double(channel.unit_per_code) * period_s_ / unit;
    return step;
  }

  // Integer taps and the unit; the largest value gets 22 bits.
  void quantise(int node, int q, double largest) {
    SignalConfiguration& signal = c_.signals[node][q];
    Design made = design(node, q);
    const double peak = largest > 0.0 ? largest : made.largest_bound;
    const double unit = std::exp2(std::ceil(std::log2(peak / kSignalPeak)));
    double biggest = 0.0;
    Impulse step;
    if (fused(node, q)) {
      step = integral_step(node, unit);
      const size_t length = std::max(made.impulse.size(), step.size());
      made.impulse = widened(made.impulse, length);
      step = widened(step, length);
    }
    for (double tap : made.impulse) biggest = std::max(biggest, std::fabs(tap / unit));
    const int bits = signal.integrations > 0 ? 25 : 30;  // inputs of 31 or 24 bits, 33 taps: the sum stays below 2^61
    const int shift = std::clamp(bits - 1 - std::ilogb(biggest), 0, 62);
    signal.shift = static_cast<uint8_t>(shift);
    const int half = static_cast<int>(made.impulse.size() / 2);
    signal.half_length = static_cast<uint8_t>(half);
    for (int k = 0; k <= 2 * half; ++k)
      signal.tap[k].raw =
          static_cast<int32_t>(std::lround(std::ldexp(made.impulse[static_cast<size_t>(k)] / unit, shift)));
    for (size_t k = 0; k < step.size(); ++k)
      c_.fusion[node].step_tap[k].raw = static_cast<int32_t>(std::lround(std::ldexp(step[k], shift)));
    signal.unit_per_code = to_scaled(unit);
  }

  // The low-pass for friction's sign, as far as the history of the signals reaches.
  void filter_signs() {
    int longest = 0;
    for (const auto& node : c_.signals)
      for (const SignalConfiguration& signal : node) longest = std::max<int>(longest, signal.half_length);
    if (!has_friction() || !differentiates() || 2 * longest + kLowPassHalf > 2 * firmware::kFilterHalf) return;
    static_assert(kLowPassHalf == firmware::kSignFilterHalf, "the same filter");
    const Impulse taps = low_pass(0.0, band());
    c_.sign_half_length = kLowPassHalf;
    for (size_t k = 0; k < taps.size(); ++k)
      c_.sign_tap[k].raw = static_cast<int32_t>(std::lround(std::ldexp(taps[k], firmware::PassedSign::kFractionBits)));
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
  bool has_friction() const {
    return std::any_of(c_.terms, c_.terms + c_.term_count,
                       [](const firmware::Term& term) { return firmware::is_sign_term(term.kind); });
  }
  int most_integrations() const {
    int most = 0;
    for (const auto& node : c_.signals)
      for (const SignalConfiguration& signal : node) most = std::max<int>(most, signal.integrations);
    return most;
  }
  int derivatives(int node, int q) const {
    const SignalConfiguration& signal = c_.signals[node][q];
    return signal.derived && signal.source < q && !fused(node, q) ? q - signal.source : 0;
  }
  bool fused(int node, int q) const { return q == kV && c_.fusion[node].used; }
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
  bool driven() const {
    bool force = c_.base_present;
    for (int node = 0; node < c_.dof_count; ++node) force = force || c_.channels[node][kF].present;
    return force;
  }
  // There the score tests take friction's sign from the velocity that has passed the high-pass.
  bool friction_without_acceleration() const {
    for (int t = 0; t < c_.term_count; ++t) {
      if (!firmware::is_sign_term(c_.terms[t].kind)) continue;
      const firmware::LinkConfiguration& link = c_.links[c_.terms[t].place];
      for (const int node : {int{link.node_a}, int{link.node_b}})
        if (node < c_.dof_count && !c_.signals[node][kA].available) return true;
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
    c_.fusion[node].used = fuse_ && !measured(kV) && measured(kX) && measured(kA);
    c_.fusion[node].leak_shift = static_cast<uint8_t>(leak_shift(node));
    take(node, kV, measured(kV) ? kV : (measured(kX) ? kX : kA));
    if (measured(kX)) {
      take(node, kX, kX);
    } else if (displacement_needed(node)) {
      take(node, kX, measured(kV) ? kV : kA);
    }
    if (measured(kA)) {
      take(node, kA, kA);
    } else if (!is_base && mass_needed(node) && !(measured(kV) && measured(kX))) {
      take(node, kA, measured(kV) ? kV : kX);
    }
  }

  // The corner at which x' of white noise sx and the integral of an acceleration of white noise sa add the least noise:
  // variance w^2 sx^2 + sa^2 T / (2 w), least at w^3 = sa^2 T / (4 sx^2). Where the noise is not known, that of sensors which
  // are equally good at the node's own frequency w0, sqrt(k / m): sa = w0^2 sx.
  int leak_shift(int node) const {
    const auto noise = [&](int q) {
      return ranges_.noise[node][q].deviation * to_double(c_.channels[node][q].unit_per_code);
    };
    const double sx = noise(kX), sa = noise(kA);
    const double ratio = sx > 0.0 && sa > 0.0 ? sa / sx : own_frequency_square(node);
    if (!(ratio > 0.0)) return kMiddleLeak;
    const double corner = std::cbrt(ratio * ratio * period_s_ / 4.0);
    return std::clamp(static_cast<int>(std::lround(-std::log2(corner * period_s_))), kLeastLeak, kMostLeak);
  }
  double own_frequency_square(int node) const {
    double mass = 0.0, stiffness = 0.0;
    for (int t = 0; t < c_.term_count; ++t) {
      const firmware::Term& term = c_.terms[t];
      if (term.kind == firmware::TermKind::kMass && term.place == node) mass = to_double(term.value);
      if (term.kind != firmware::TermKind::kStiffness) continue;
      const firmware::LinkConfiguration& link = c_.links[term.place];
      if (link.node_a == node || link.node_b == node) stiffness += to_double(term.value);
    }
    return mass > 0.0 ? stiffness / mass : 0.0;
  }

  CoreConfiguration& c_;
  const SignalRanges& ranges_;
  double period_s_;
  bool fuse_ = true;
};

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

// The signals' values over one record, in double: as firmware/conditioning, without its rounding.
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

// Noise that is in the neighbours of a sample although nothing is filtered. A displacement tells: its motion does not reach the top
// of the spectrum.
bool coloured_displacement(const CoreConfiguration& c, const SignalRanges& ranges) {
  for (int node = 0; node < c.dof_count; ++node)
    if (c.channels[node][kX].present && !ranges.noise[node][kX].white()) return true;
  return false;
}

}  // namespace

void plan_signals(CoreConfiguration& configuration, const SignalRanges& ranges) {
  Plan plan(configuration, ranges);
  plan.choose_sources();
  for (auto& node : configuration.shared_noise)
    for (auto& weight : node)
      for (firmware::Scaled& product : weight) product = {};
  for (firmware::ProbeNoise& node : configuration.probe_noise) node = {};
  configuration.noise_unknown = configuration.shares_probe_noise = false;
  std::fill_n(configuration.motion_noise_doubt, firmware::kMaxNodes, uint16_t{0});
  std::fill_n(configuration.force_noise_doubt, firmware::kMaxNodes, uint16_t{0});
  configuration.sign_half_length = 0;
  if (!plan.filtered()) {
    if (coloured_displacement(configuration, ranges)) find_shared_noise(configuration, ranges);
    return;
  }
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (configuration.signals[node][q].available) plan.quantise(node, q, ranges.largest[node][q]);
  plan.filter_signs();
  find_shared_noise(configuration, ranges);
}

SignalRanges measure_ranges(const CoreConfiguration& configuration,
                            const std::vector<std::vector<firmware::RawSample>>& records, Corner corner) {
  SignalRanges ranges;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (configuration.channels[node][q].present)
        ranges.noise[node][q] = read_noise(records, node, q, 1.0 / to_double(configuration.sample_period_s));
  CoreConfiguration planned = configuration;
  if (corner == Corner::kBelowMotion && planned.high_pass_order > 0) {
    const int as_configured = planned.high_pass_shift - Plan(planned, ranges).octaves_of_period();
    ranges.octaves_to_slowest_motion = octaves_to_slowest_motion(planned, records, ranges.noise, as_configured);
    if (*ranges.octaves_to_slowest_motion < as_configured) plan_signals(planned, ranges);
  }
  if (Plan(planned, ranges).differentiates()) {
    for (int node = 0; node < firmware::kMaxNodes; ++node)
      for (const int q : {kX, kV}) {
        const bool told = planned.channels[node][q].present && (q == kX || planned.signals[node][kA].source == kV);
        ranges.wide_band = ranges.wide_band || (told && moves_beyond_a_tenth(records, node, q, ranges.noise[node][q]));
      }
    if (ranges.wide_band) plan_signals(planned, ranges);
  }
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) {
      const SignalConfiguration& signal = planned.signals[node][q];
      if (!signal.available || (signal.half_length == 0 && signal.tap[0].raw == 0)) continue;
      for (const auto& record : records)
        ranges.largest[node][q] = std::max(ranges.largest[node][q], largest_value(planned, node, q, record));
    }
  return ranges;
}

bool differentiates(const CoreConfiguration& planned) {
  CoreConfiguration copy = planned;
  return Plan(copy, {}).differentiates();
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
              (q == kV && planned.fusion[node].used ? " fused from displacement and acceleration"
                                                    : std::string(" derived from ") + kNames[signal.source]);
    }
  return text;
}

}  // namespace rig_file
