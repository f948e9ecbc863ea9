#include "sensors.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

constexpr double kTwoPi = 6.283185307179586;
const char* const kFaults[] = {"sensor_delay", "sensor_gain", "mains_hum"};

void add_noise(Dice& dice, Values& values, const Settings& s) {
  const double level = s.noise * rms(values);
  if (s.noise_corner_Hz > 0) {
    const double keep = std::exp(-kTwoPi * s.noise_corner_Hz * kPeriod), drive = std::sqrt(1 - keep * keep);
    double state = dice.gauss();
    for (double& v : values) v += level * state, state = keep * state + drive * dice.gauss();
  } else {
    for (double& v : values) v += level * dice.gauss();
  }
}

void quantise(Values& values, int bits) {
  if (bits <= 0) return;
  double peak = 0;
  for (double v : values) peak = std::max(peak, std::abs(v));
  const double step = 2 * 1.25 * peak / std::pow(2.0, bits);
  for (double& v : values) v = step * std::round(v / step);
}

// value of a channel at a time between its samples (cubic through four)
double at(const Values& v, double position) {
  const double clamped = std::clamp(position, 1.0, static_cast<double>(v.size()) - 3.0);
  const size_t i = static_cast<size_t>(clamped);
  const double r = clamped - static_cast<double>(i);
  const double a = v[i - 1], b = v[i], c = v[i + 1], d = v[i + 2];
  return b + 0.5 * r * (c - a + r * (2 * a - 5 * b + 4 * c - d + r * (3 * (b - c) + d - a)));
}

}  // namespace

double rms(const Values& v) {
  double sum = 0;
  for (double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(v.size()));
}

namespace {

void sensor_fault(Dice& dice, Draw& draw, const Settings& s) {
  std::vector<host_sim::Channel*> list;
  for (host_sim::Channel& c : draw.record.channels)
    if (s.channel.empty() || c.name == s.channel) list.push_back(&c);
  host_sim::Channel& channel = *list.at(static_cast<size_t>(dice.below(static_cast<int>(list.size()))));
  Hidden truth;
  truth.effect = s.kind.empty() ? kFaults[dice.below(3)] : s.kind;
  truth.where = "channel " + channel.name;
  truth.rho = s.kind.empty() ? dice.log_between(0.01, 0.1) : dice.between(s.rho_low, s.rho_high);
  const double sign = dice.sign(), level = rms(channel.values) * truth.rho * 1.4142135623730951;
  const double mains = dice.chance(0.5) ? 50 : 60, phase = dice.between(0, kTwoPi);
  if (truth.effect == "sensor_delay") {
    truth.strength = truth.rho * 0.01;  // 0.1 to 1 ms
    const Values old = channel.values;
    for (size_t i = 0; i < old.size(); ++i)
      channel.values[i] = at(old, static_cast<double>(i) - truth.strength / kPeriod);
  } else if (truth.effect == "sensor_gain") {
    truth.strength = sign * truth.rho;
    for (double& v : channel.values) v *= 1 + truth.strength;
  } else {
    truth.strength = mains;
    for (size_t i = 0; i < channel.values.size(); ++i)
      channel.values[i] += level * std::sin(kTwoPi * mains * static_cast<double>(i) * kPeriod + phase);
  }
  draw.truth.push_back(truth);
}

void disturb(Dice& dice, Values& values, const Settings& s) {
  add_noise(dice, values, s);
  quantise(values, s.bits);
}

}  // namespace

void measure(Dice& dice, Draw& draw, const Motion& motion, const Values& force, const Settings& s) {
  using host_sim::Quantity;
  host_sim::Record& record = draw.record;
  record.file = "draw.csv";
  record.sample_period_s = kPeriod;
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, force});
  for (size_t i = 0; i < motion.x.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const int dof = static_cast<int>(i) + 1;
    if (s.sensors.find('x') != std::string::npos)
      record.channels.push_back({"displacement_" + number + "_m", Quantity::kDisplacement, dof, motion.x[i]});
    if (s.sensors.find('v') != std::string::npos)
      record.channels.push_back({"velocity_" + number + "_m_s", Quantity::kVelocity, dof, motion.v[i]});
    if (s.sensors.find('a') != std::string::npos)
      record.channels.push_back({"acceleration_" + number + "_m_s2", Quantity::kAcceleration, dof, motion.a[i]});
  }
  if (s.hide == Hide::kSensorFault) sensor_fault(dice, draw, s);
  for (host_sim::Channel& c : record.channels) disturb(dice, c.values, s);
}

Settings settings_of_seed(uint64_t seed) {
  Dice dice(seed ^ 0xABCDEF);
  Settings s;
  s.noise = dice.chance(0.5) ? 0.01 : 0.05;
  const double r = dice.uniform();
  s.hide = r < 0.15   ? Hide::kNothing
           : r < 0.65 ? Hide::kOne
           : r < 0.8  ? Hide::kTwo
           : r < 0.9  ? Hide::kOutside
                      : Hide::kSensorFault;
  return s;
}

}  // namespace hidden
