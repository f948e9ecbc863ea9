#include "tests/data_check/made_records.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "hal/rig_file/toml/rig_reader.hpp"

namespace made {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMass[2] = {2.0, 1.0}, kSpring[2] = {2000.0, 1500.0}, kDamper[2] = {4.0, 3.0};

using State = std::array<double, 4>;  // x1, x2, v1, v2

// tanh in place of the sign: friction that holds creeps by less than 1e-5 of the motion here.
State slope(const State& s, double force, double friction) {
  const double between = kSpring[1] * (s[0] - s[1]) + kDamper[1] * (s[2] - s[3]);
  const double ground = kSpring[0] * s[0] + kDamper[0] * s[2] + friction * std::tanh(s[2] / 1e-4);
  return {s[2], s[3], (force - ground - between) / kMass[0], between / kMass[1]};
}

std::vector<double> force_of(const Options& options, size_t count, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> force(count, 0.0);
  const double T = 1.0 / options.rate_Hz;
  double low = 0.0, lower = 0.0;
  for (size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * T;
    switch (options.drive) {
      case Drive::kRandom:  // white, low-passed twice at 20 Hz
        low += (normal(random) - low) * std::min(1.0, 2.0 * kPi * 20.0 * T);
        lower += (low - lower) * std::min(1.0, 2.0 * kPi * 20.0 * T);
        force[i] = 30.0 * lower;
        break;
      case Drive::kTwoTones:
        force[i] = 5.0 * std::sin(2.0 * kPi * 3.3 * t) + 5.0 * std::sin(2.0 * kPi * 7.7 * t);
        break;
      case Drive::kSweep:
        force[i] = 10.0 * std::sin(2.0 * kPi * (0.5 * t + 0.5 * t * t));
        break;
      case Drive::kHammer:  // every 4 s a half sine of 4 ms
        if (const double since = std::fmod(t, 4.0) - 0.5; since >= 0.0 && since < 0.004)
          force[i] = 800.0 * std::sin(kPi * since / 0.004);
        break;
      case Drive::kDecay:
      case Drive::kDecayToRest:
      case Drive::kRelease:
        break;
    }
  }
  return force;
}

}  // namespace

rig_file::RigModel chain() {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[dof]]\nmass_kg = 1.0\n"
      "[[link]]\nbetween = [1, 0]\nstiffness_N_m = 2000.0\nviscous_N_s_m = \"estimate\"\ncoulomb_N = \"estimate\"\n"
      "[[link]]\nbetween = [1, 2]\nstiffness_N_m = 1500.0\nviscous_N_s_m = \"estimate\"\n",
      "rig.toml");
}

host_sim::Record record(const Options& options) {
  constexpr int kSubsteps = 8;
  std::mt19937 random(options.seed);
  const auto count = static_cast<size_t>(options.duration_s * options.rate_Hz);
  const std::vector<double> force = force_of(options, count, random);
  const bool decay = options.drive == Drive::kDecay || options.drive == Drive::kDecayToRest;
  const double friction = options.drive == Drive::kDecayToRest ? 1.0 : options.friction_N;
  State s = decay || options.drive == Drive::kRelease ? State{0.01, 0.02, 0.0, 0.0} : State{};
  std::vector<std::vector<double>> out(6);
  const double h = 1.0 / options.rate_Hz / kSubsteps;
  for (size_t i = 0; i < count; ++i) {
    const bool held = options.drive == Drive::kRelease && static_cast<double>(i) < 2.0 * options.rate_Hz;
    const State a = held ? State{} : slope(s, force[i], friction);
    for (const auto& [k, value] : {std::pair<int, double>{0, s[0]},
                                   {1, held ? 0.0 : s[2]},
                                   {2, a[2]},
                                   {3, s[1]},
                                   {4, held ? 0.0 : s[3]},
                                   {5, a[3]}})
      out[static_cast<size_t>(k)].push_back(value);
    const double next = i + 1 < count ? force[i + 1] : force[i];
    for (int k = 0; k < kSubsteps && !held; ++k) {
      const double f = force[i] + (next - force[i]) * (k + 0.5) / kSubsteps;
      const State k1 = slope(s, f, friction);
      State middle = s;
      for (size_t j = 0; j < 4; ++j) middle[j] += 0.5 * h * k1[j];
      const State k2 = slope(middle, f, friction);
      for (size_t j = 0; j < 4; ++j) s[j] += h * k2[j];
    }
  }
  host_sim::Record result;
  result.file = "made.csv";
  result.sample_period_s = 1.0 / options.rate_Hz;
  std::normal_distribution<double> normal;
  const auto add = [&](const std::string& name, host_sim::Quantity quantity, int dof, std::vector<double> samples) {
    double square = 0.0;
    for (const double value : samples) square += value * value / static_cast<double>(count);
    for (double& value : samples) value += options.noise * std::sqrt(square) * normal(random);
    result.channels.push_back({name, quantity, dof, std::move(samples)});
  };
  if (!decay && options.drive != Drive::kRelease) add("force_1_N", host_sim::Quantity::kForce, 1, force);
  for (int dof = 1; dof <= 2; ++dof) {
    const std::string number = std::to_string(dof);
    const size_t base = dof == 1 ? 0 : 3;
    if (options.sensors.find('x') != std::string::npos)
      add("displacement_" + number + "_m", host_sim::Quantity::kDisplacement, dof, out[base]);
    if (options.sensors.find('v') != std::string::npos)
      add("velocity_" + number + "_m_s", host_sim::Quantity::kVelocity, dof, out[base + 1]);
    if (options.sensors.find('a') != std::string::npos)
      add("acceleration_" + number + "_m_s2", host_sim::Quantity::kAcceleration, dof, out[base + 2]);
  }
  if (options.encoder_m > 0.0)
    for (host_sim::Channel& channel : result.channels)
      if (channel.quantity == host_sim::Quantity::kDisplacement)
        for (double& value : channel.values) value = options.encoder_m * std::nearbyint(value / options.encoder_m);
  return result;
}

std::vector<double>& values(host_sim::Record& record, const std::string& name) {
  for (host_sim::Channel& channel : record.channels)
    if (channel.name == name) return channel.values;
  throw std::logic_error(name + " is not in the record");
}

}  // namespace made
