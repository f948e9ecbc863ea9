#include "sensors.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "noise.hpp"

namespace hidden_rig {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kCorner = 0.22;  // of the anti-alias filter, per sample

// The signal late by `delay` samples: windowed sinc over 24 samples.
Values delayed(const Values& v, double delay) {
  constexpr int kHalf = 12;
  Values out(v.size());
  const double whole = std::floor(delay), part = delay - whole;
  double weight[2 * kHalf];
  double sum = 0;
  for (int j = 0; j < 2 * kHalf; ++j) {
    const double at = j - (kHalf - 1) + part;  // distance from the wanted instant
    const double window = 0.5 + 0.5 * std::cos(0.5 * kTwoPi * at / kHalf);
    weight[j] = (std::abs(at) < 1e-12 ? 1.0 : std::sin(0.5 * kTwoPi * at) / (0.5 * kTwoPi * at)) * window;
    sum += weight[j];
  }
  const long n = static_cast<long>(v.size());
  for (long i = 0; i < n; ++i) {
    double value = 0;
    for (int j = 0; j < 2 * kHalf; ++j) {
      const long from = std::clamp<long>(i - static_cast<long>(whole) + j - (kHalf - 1), 0, n - 1);
      value += weight[j] * v[static_cast<size_t>(from)];
    }
    out[static_cast<size_t>(i)] = value / sum;
  }
  return out;
}

void apply_fault(const TrueEffect& e, double period_s, Values& v) {
  const double level = rms(v);
  if (e.kind == "sensor_delay" || e.kind == "force_delay") v = delayed(v, e.strength / period_s);
  if (e.kind == "sensor_gain" || e.kind == "polarity" || e.kind == "unit")
    for (double& x : v) x *= 1 + e.strength;
  if (e.kind == "dead")
    for (size_t i = v.size() * 2 / 3; i < v.size(); ++i) v[i] = v[v.size() * 2 / 3];
  if (e.kind == "clipped")
    for (double& x : v) x = std::clamp(x, -e.strength * level, e.strength * level);
  if (e.kind == "mains_hum")
    for (size_t i = 0; i < v.size(); ++i)
      v[i] += std::sqrt(2.0) * e.strength * level *
              std::sin(kTwoPi * e.shape * static_cast<double>(i) * period_s + e.phase);
  if (e.kind == "spikes")
    for (size_t i = 97; i < v.size(); i += 211) v[i] += (i % 2 == 0 ? 1 : -1) * e.strength * level;
  if (e.kind == "drift")
    for (size_t i = 0; i < v.size(); ++i)
      v[i] += e.strength * level * (2.0 * static_cast<double>(i) / static_cast<double>(v.size()) - 1);
}

void round_to_bits(Values& v, int bits) {
  double peak = 0;
  for (double x : v) peak = std::max(peak, std::abs(x));
  const double step = 2 * 1.25 * peak / std::pow(2.0, bits);
  if (step > 0)
    for (double& x : v) x = step * std::round(x / step);
}

void disturb(Dice& dice, const Condition& c, bool motion, double period_s, size_t lead_in, Values& v) {
  const Values clean(v.begin() + static_cast<long>(lead_in), v.end());
  const double level = rms(clean);
  const Values noise = draw_noise(dice, c, v.size());
  const bool filters = c.filter != AntiAlias::kNone && (motion || c.filter != AntiAlias::kMotionOnly);
  const bool before = c.filter == AntiAlias::kNoiseBefore;
  if (filters && !before) low_pass(v, kCorner);
  for (size_t i = 0; i < v.size(); ++i) v[i] += c.noise * level * noise[i];
  if (filters && before) low_pass(v, kCorner);
  v.erase(v.begin(), v.begin() + static_cast<long>(lead_in));
  if (c.hum_Hz > 0) {
    const double phase = dice.between(0, kTwoPi);
    for (size_t i = 0; i < v.size(); ++i)
      v[i] += 0.003 * level * std::sqrt(2.0) * std::sin(kTwoPi * c.hum_Hz * static_cast<double>(i) * period_s + phase);
  }
  if (c.drift > 0) {
    const Values drift = draw_drift(dice, v.size());
    for (size_t i = 0; i < v.size(); ++i) v[i] += c.drift * level * drift[i];
  }
  if (c.bits > 0) round_to_bits(v, c.bits);
}

struct Channels {
  host_sim::Record& record;
  bool rotating;
  void add(firmware::Quantity quantity, int dof, const Values& values) {
    host_sim::Channel channel;
    channel.name = rig_file::format_channel_name({quantity, dof, rotating});
    channel.quantity = static_cast<host_sim::Quantity>(quantity);
    channel.dof = dof;
    channel.values = values;
    record.channels.push_back(std::move(channel));
  }
};

void add_motion(Channels& channels, const std::string& sensors, int dof, const Values& x, const Values& v,
                const Values& a) {
  if (sensors.find('x') != std::string::npos) channels.add(firmware::Quantity::kDisplacement, dof, x);
  if (sensors.find('v') != std::string::npos) channels.add(firmware::Quantity::kVelocity, dof, v);
  if (sensors.find('a') != std::string::npos) channels.add(firmware::Quantity::kAcceleration, dof, a);
}

Values samples_of(const Values& half_substeps, int substeps, size_t first, size_t count) {
  Values out(count);
  for (size_t i = 0; i < count; ++i) out[i] = half_substeps[2 * static_cast<size_t>(substeps) * (first + i)];
  return out;
}

}  // namespace

host_sim::Record measure(Dice& dice, const Condition& c, const std::vector<std::string>& sensors, const TrueRig& rig,
                         const Motion& motion, const Drive& drive, size_t drive_skip, size_t lead_in) {
  host_sim::Record record;
  record.file = "draw.csv";
  record.sample_period_s = drive.sample_period_s;
  Channels channels{record, rig.rotating};
  const size_t count = motion.x[0].size();
  for (size_t i = 0; i < drive.force_N.size(); ++i)
    if (!drive.force_N[i].empty())
      channels.add(firmware::Quantity::kForce, static_cast<int>(i) + 1,
                   samples_of(drive.force_N[i], drive.substeps, drive_skip, count));
  for (size_t i = 0; i < motion.x.size(); ++i)
    add_motion(channels, sensors[i], static_cast<int>(i) + 1, motion.x[i], motion.v[i], motion.a[i]);
  if (!drive.base_x.empty())
    add_motion(channels, sensors.back(), rig_file::kBase, samples_of(drive.base_x, drive.substeps, drive_skip, count),
               samples_of(drive.base_v, drive.substeps, drive_skip, count),
               samples_of(drive.base_a, drive.substeps, drive_skip, count));
  for (host_sim::Channel& channel : record.channels) {
    for (const TrueEffect& e : rig.effects)
      if (e.channel == channel.name) apply_fault(e, drive.sample_period_s, channel.values);
    disturb(dice, c, channel.quantity != host_sim::Quantity::kForce, drive.sample_period_s, lead_in, channel.values);
  }
  return record;
}

TrueEffect draw_fault(Dice& dice, const std::string& kind, const std::vector<std::string>& channels, double period_s) {
  TrueEffect e;
  e.kind = kind;
  std::vector<std::string> eligible;
  const bool force_only = kind == "force_delay" || kind == "force_hold";
  for (const std::string& name : channels) {
    const bool force = name.rfind("force", 0) == 0 || name.rfind("torque", 0) == 0;
    if (!force_only || force) eligible.push_back(name);
  }
  if (eligible.empty()) return e;
  e.channel = eligible[static_cast<size_t>(dice.below(static_cast<int>(eligible.size())))];
  if (kind == "sensor_delay" || kind == "force_delay") e.strength = period_s * dice.log_between(0.1, 1);
  if (kind == "sensor_gain") e.strength = dice.sign() * dice.log_between(0.01, 0.1);
  if (kind == "polarity") e.strength = -2;
  if (kind == "unit") e.strength = (dice.chance(0.5) ? 9.80665 : (dice.chance(0.5) ? 1000 : 1e-3)) - 1;
  if (kind == "clipped") e.strength = dice.between(1, 2);
  if (kind == "mains_hum")
    e.strength = dice.log_between(0.01, 0.1), e.shape = dice.chance(0.5) ? 50 : 60, e.phase = dice.between(0, kTwoPi);
  if (kind == "spikes") e.strength = dice.between(5, 20);
  if (kind == "drift") e.strength = dice.sign() * dice.between(0.3, 2);
  return e;
}

}  // namespace hidden_rig
