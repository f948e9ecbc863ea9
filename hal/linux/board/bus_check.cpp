#include "hal/linux/board/bus_check.hpp"

#include <algorithm>
#include <optional>

#include "firmware/can_protocol/load/bus_plan.hpp"
#include "hal/rig_file/rig_file_error.hpp"

namespace board {
namespace {

using firmware::BitRates;
using firmware::SensorWiring;

// What can be changed to make a rig fit.
struct Choice {
  SensorWiring wiring;
  double rate_Hz;
  bool drive_on_can;
  bool can_fd;
  BitRates rates;
};

Choice chosen(const BoardFile& file) {
  const firmware::NodeConfiguration& node = file.controller.node;
  return {file.samples.wiring, file.samples.rate_Hz, node.drive_on_can, node.can_fd, file.bit_rates};
}

firmware::BusPlan plan_of(const BoardFile& file, const Choice& choice) {
  const firmware::NodeConfiguration& node = file.controller.node;
  const firmware::SensorPlan sensors = firmware::sensor_plan(file.controller.core, choice.wiring);
  firmware::BusTraffic traffic;
  if (file.samples.kind == SampleKind::kCan) traffic.sensors = &sensors;
  traffic.sample_period_ns = static_cast<int64_t>(1e9 / choice.rate_Hz);
  traffic.drive_on_can = choice.drive_on_can;
  traffic.can_fd = choice.can_fd;
  traffic.float_estimates = firmware::sends_float_estimates(file.controller);
  traffic.heartbeat_ms = node.heartbeat_ms;
  traffic.status_ms = node.status_ms;
  traffic.window_ns = static_cast<int64_t>(node.window_samples * 1e9 / file.samples.rate_Hz);
  traffic.unknowns = file.controller.core.unknown_count;
  traffic.channels = static_cast<int>(file.rig.channels.size());
  return firmware::bus_plan(traffic);
}

int64_t load_of(const BoardFile& file, const Choice& choice) {
  return firmware::load_permille(plan_of(file, choice), choice.rates);
}

std::string percent(int64_t permille) { return std::to_string((permille + 9) / 10) + " %"; }

std::string rates_text(const Choice& choice) {
  const std::string nominal = std::to_string(choice.rates.nominal / 1000) + " kbit/s";
  const bool fd = choice.wiring == SensorWiring::kFd || choice.can_fd;
  return fd ? nominal + " (data " + std::to_string(choice.rates.data / 1000) + " kbit/s)" : nominal;
}

std::string describe_load(const BoardFile& file, const Choice& choice) {
  const firmware::BusPlan plan = plan_of(file, choice);
  std::string parts;
  int64_t reports = 0;
  for (int i = 0; i < plan.count; ++i) {
    const int64_t load = firmware::load_permille(plan.streams[i], choice.rates);
    if (load < 50)  // under 5 % each: together
      reports += load;
    else
      parts += std::string(plan.streams[i].frame->name) + " " + percent(load) + ", ";
  }
  return percent(firmware::load_permille(plan, choice.rates)) + " of " + rates_text(choice) + " at worst: " + parts +
         "the rest " + percent(reports);
}

// The fastest sampling that fits, in whole 10 Hz; frames at each sample take a share that is in proportion to it.
std::optional<int> fastest_Hz(const BoardFile& file, Choice choice) {
  for (int rate = static_cast<int>(choice.rate_Hz) / 10 * 10; rate >= 10; rate -= 10) {
    choice.rate_Hz = rate;
    if (load_of(file, choice) <= firmware::kHighestLoad_permille) return rate;
  }
  return std::nullopt;
}

std::string alternatives(const BoardFile& file) {
  const bool sensors = file.samples.kind == SampleKind::kCan;
  const Choice now = chosen(file);
  std::string text;
  const auto offer = [&](const std::string& what, const Choice& choice) {
    const int64_t load = load_of(file, choice);
    if (load <= firmware::kHighestLoad_permille) text += (text.empty() ? "" : "; ") + what + " (" + percent(load) + ")";
  };
  Choice other = now;
  other.rates.nominal = std::max<int64_t>(now.rates.nominal, 1000000);
  other.rates.data = std::max(now.rates.data, other.rates.nominal);
  if (other.rates.nominal != now.rates.nominal) offer("bit_rate_kbit_s = 1000", other);
  if (sensors && now.wiring == SensorWiring::k24) {
    Choice pairs = other;
    pairs.wiring = SensorWiring::kPairs;
    offer("wiring = \"pairs\", at 1000 kbit/s", pairs);
    other.wiring = SensorWiring::k16;
    offer("wiring = \"16\" for sensors of 16 bits, at 1000 kbit/s", other);
  }
  if (sensors && now.wiring != SensorWiring::kFd) {
    other = now;
    other.wiring = SensorWiring::kFd;
    offer("CAN FD sensor frames, wiring = \"fd\"", other);
    other.rates = {1000000, 5000000};
    offer("wiring = \"fd\" at 1000 and 5000 kbit/s", other);
  }
  if (now.drive_on_can) {
    other = now;
    other.drive_on_can = false;
    offer("the drive by a converter of this board, output = \"iio\"", other);
  }
  const std::optional<int> rate = fastest_Hz(file, now);
  if (rate) {
    other = now;
    other.rate_Hz = *rate;
    offer("rate_Hz = " + std::to_string(*rate), other);
  }
  return text.empty() ? "another bus for the sensors" : text;
}

}  // namespace

BusCheck check_bus(const BoardFile& file) {
  BusCheck result;
  if (file.can_interface.rfind("vcan", 0) == 0) {
    result.load = "virtual, without a bit rate";
    return result;
  }
  const Choice choice = chosen(file);
  result.load = describe_load(file, choice);
  result.fits = load_of(file, choice) <= firmware::kHighestLoad_permille;
  if (!result.fits) result.instead = alternatives(file);
  return result;
}

// They repeat what the other estimates say, so they give way first.
void fit_float_estimates(BoardFile& file) {
  firmware::FloatEstimates& floats = file.controller.node.float_estimates;
  if (floats == firmware::FloatEstimates::kWhereLoadAllows && !check_bus(file).fits)
    floats = firmware::FloatEstimates::kNever;
}

void require_bus(const BoardFile& file) {
  const BusCheck check = check_bus(file);
  if (check.fits) return;
  throw rig_file::RigFileError(
      file.path, 0, "can",
      "the frames of this rig take " + check.load + "; expected at most 80 %. What would fit: " + check.instead);
}

}  // namespace board
