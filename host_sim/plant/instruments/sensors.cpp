#include "host_sim/plant/instruments/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <future>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "host_sim/plant/instruments/random_numbers.hpp"
#include "host_sim/plant/instruments/shaker.hpp"
#include "host_sim/plant/motion/motion_record.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/records/digitise.hpp"

namespace host_sim {
namespace {

const SensorChannel& sensor_of(const Scenario& scenario, const std::string& name) {
  const auto found = scenario.sensors.channel.find(name);
  return found == scenario.sensors.channel.end() ? scenario.sensors.every : found->second;
}

bool drives(const Scenario& scenario, int dof) {
  return std::any_of(scenario.levels.begin(), scenario.levels.end(), [&](const ExcitationLevel& level) {
    return (level.kind == LevelKind::kSine || level.kind == LevelKind::kRandom) && level.dof == dof;
  });
}

bool base_linked(const Scenario& scenario) {
  return std::any_of(scenario.rig.links.begin(), scenario.rig.links.end(),
                     [](const rig_file::Link& link) { return link.b == rig_file::kBase; });
}

// One stream of random numbers per level and channel place, so that leaving a channel out changes no other.
uint64_t noise_stream(size_t level, const Channel& channel) {
  return 1000000 + level * 1000 + static_cast<uint64_t>(rig_file::node_index(channel.dof)) * 8 +
         static_cast<uint64_t>(channel.quantity);
}

double measured_rms(const std::vector<double>& values, const ExcitationLevel& level) {
  double sum = 0.0;
  for (size_t k = 0; k < level.samples; ++k) sum += values[level.settle_samples + k] * values[level.settle_samples + k];
  return std::sqrt(sum / static_cast<double>(level.samples));
}

void add_faults(const SensorChannel& sensor, const ExcitationLevel& level, double h, uint64_t seed, uint64_t stream,
                std::vector<double>& values) {
  const double noise = 0.01 * sensor.noise_percent * measured_rms(values, level);
  const double keep = sensor.noise_corner_Hz > 0.0 ? std::exp(-6.283185307179586 * sensor.noise_corner_Hz * h) : 0.0;
  const double fresh = std::sqrt(1.0 - keep * keep);
  RandomNumbers random(seed, stream);
  double state = noise > 0.0 && keep > 0.0 ? random.normal() : 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    const double t = (static_cast<double>(k) - static_cast<double>(level.settle_samples)) * h;
    values[k] += sensor.offset + sensor.drift_per_s * t;
    if (noise == 0.0) continue;
    state = keep * state + fresh * random.normal();
    values[k] += noise * state;
  }
}

rig_file::ChannelCalibration calibrate_channel(const Scenario& scenario, const Channel& channel, double largest) {
  const SensorChannel& sensor = sensor_of(scenario, channel.name);
  rig_file::ChannelCalibration calibration;
  calibration.quantity = static_cast<firmware::Quantity>(channel.quantity);
  calibration.dof = channel.dof;
  calibration.highest_code = static_cast<int32_t>((1L << (sensor.bits - 1)) - 1);
  calibration.lowest_code = -calibration.highest_code;
  const double codes = static_cast<double>(calibration.highest_code);
  int exponent = 0;  // 2^exponent codes >= headroom * largest
  std::frexp(largest > 0.0 ? largest * scenario.sensors.headroom / codes : 1.0, &exponent);
  calibration.unit_per_code = sensor.full_scale > 0.0 ? sensor.full_scale / codes : std::ldexp(1.0, exponent);
  if (const rig_file::ChannelEntry* const entry = rig_file::entry_of(scenario.rig, channel.name))
    calibration.take(*entry);
  return calibration;
}

Record only(const std::vector<Channel>& wanted, const Record& simulated) {
  Record record;
  record.file = simulated.file;
  record.sample_period_s = simulated.sample_period_s;
  record.start_s = simulated.start_s;
  for (const Channel& channel : wanted) {
    record.channels.push_back(channel);
    const Channel* source = simulated.find(channel.quantity, channel.dof);
    record.channels.back().values = source == nullptr ? std::vector<double>(simulated.samples(), 0.0) : source->values;
  }
  return record;
}

Record measured_level(const Scenario& scenario, size_t level, uint64_t seed, const Excitation& excitation,
                      Record record) {
  record.file = "level " + std::to_string(level + 1);  // as messages call it
  std::map<double, Record> delayed;                    // by delay: the same motion at shifted sample times
  for (Channel& channel : record.channels) {
    const SensorChannel& sensor = sensor_of(scenario, channel.name);
    if (sensor.delay_us != 0.0) {
      if (delayed.count(sensor.delay_us) == 0)
        delayed[sensor.delay_us] = simulate_level(scenario, level, excitation, -sensor.delay_us * 1e-6);
      if (const Channel* late = delayed[sensor.delay_us].find(channel.quantity, channel.dof))
        channel.values = late->values;
    }
    add_faults(sensor, scenario.levels[level], record.sample_period_s, seed, noise_stream(level, channel),
               channel.values);
  }
  return record;
}

void round_to_codes(const std::vector<rig_file::ChannelCalibration>& calibrations, Record& record) {
  for (size_t c = 0; c < record.channels.size(); ++c)
    for (double& value : record.channels[c].values)
      value = (to_code(value, calibrations[c]) - calibrations[c].offset_code) * calibrations[c].unit_per_code;
}

}  // namespace

std::vector<Channel> measured_channels(const Scenario& scenario) {
  std::vector<Channel> channels;
  const auto add = [&](Quantity quantity, int dof) {
    const size_t of = dof > 0 ? static_cast<size_t>(dof - 1) : 0;
    Channel channel{channel_name(quantity, dof, scenario.rig.dofs[of].rotating), quantity, dof, {}};
    const std::vector<std::string>& absent = scenario.sensors.absent;
    if (std::find(absent.begin(), absent.end(), channel.name) == absent.end()) channels.push_back(std::move(channel));
  };
  for (int dof = 1; dof <= static_cast<int>(scenario.rig.dofs.size()); ++dof)
    for (Quantity quantity : scenario.sensors.quantities)
      if (quantity != Quantity::kForce || drives(scenario, dof)) add(quantity, dof);
  if (base_linked(scenario))
    for (Quantity quantity : scenario.sensors.quantities)
      if (quantity != Quantity::kForce) add(quantity, rig_file::kBase);
  return channels;
}

MeasuredLevels measure(const Scenario& scenario, uint64_t seed) {
  MeasuredLevels result;
  const std::vector<Channel> channels = measured_channels(scenario);
  if (channels.empty()) throw PlantError("scenario " + scenario.name + " measures no channel");
  struct Level {
    Excitation excitation;
    Record truth, measured;
  };
  std::vector<std::future<Level>> levels;  // beside each other: no level knows of another
  for (size_t number = 0; number < scenario.levels.size(); ++number)
    levels.push_back(std::async(std::launch::async, [&scenario, &channels, seed, number] {
      Level level;
      level.excitation = level_excitation(scenario, number, seed);
      level.truth = simulate_level(scenario, number, level.excitation);
      level.measured = measured_level(scenario, number, seed, level.excitation, only(channels, level.truth));
      return level;
    }));
  std::vector<double> largest(channels.size(), 0.0);
  for (std::future<Level>& made : levels) {
    Level level = made.get();
    for (size_t c = 0; c < channels.size(); ++c)
      for (double value : level.measured.channels[c].values) largest[c] = std::max(largest[c], std::fabs(value));
    result.excitation.push_back(std::move(level.excitation));
    result.truth.push_back(std::move(level.truth));
    result.measured.push_back(std::move(level.measured));
  }
  for (size_t c = 0; c < channels.size(); ++c)
    result.calibrations.push_back(calibrate_channel(scenario, channels[c], largest[c]));
  for (Record& record : result.measured) round_to_codes(result.calibrations, record);
  return result;
}

}  // namespace host_sim
