// What the tests of faults share: faults put into made records, and what is found of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/report/to_json.hpp"
#include "tests/data_check/made_records.hpp"

namespace faults {

using host_sim::Record;
using host_sim::data_check::Finding;
using host_sim::data_check::Report;
using host_sim::data_check::Weight;

struct Fault {
  const char* name;
  made::Options options;
  std::function<void(Record&)> spoil;
  const char* kind;
  const char* channel;
  bool with_rig = true;
  const char* says = "";
};

inline std::function<void(Record&)> times(const std::string& channel, double factor) {
  return [=](Record& record) {
    for (double& value : made::values(record, channel)) value *= factor;
  };
}
inline std::function<void(Record&)> all_times(char quantity, double factor) {  // 'd', 'v', 'a', 'f'
  return [=](Record& record) {
    for (host_sim::Channel& channel : record.channels)
      if (channel.name[0] == quantity)
        for (double& value : channel.values) value *= factor;
  };
}
inline std::function<void(Record&)> exchange(const std::string& one, const std::string& other) {
  return [=](Record& record) { std::swap(made::values(record, one), made::values(record, other)); };
}
inline std::function<void(Record&)> set(const std::string& channel, double constant) {
  return [=](Record& record) {
    for (double& value : made::values(record, channel)) value = constant;
  };
}
inline std::function<void(Record&)> spike(const std::string& channel, size_t at, double size) {
  return [=](Record& record) { made::values(record, channel)[at] += size; };
}
// At `share` of the largest value.
inline std::function<void(Record&)> clip(const std::string& channel, double share) {
  return [=](Record& record) {
    std::vector<double>& values = made::values(record, channel);
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    for (double& value : values) value = std::clamp(value, -share * largest, share * largest);
  };
}

inline made::Options with(const std::string& sensors, made::Drive drive = made::Drive::kRandom, double noise = 1e-3) {
  made::Options options;
  options.sensors = sensors;
  options.drive = drive;
  options.noise = noise;
  return options;
}

inline const Finding* find(const Report& report, const std::string& kind, const std::string& channel) {
  for (const auto& record : report.records)
    for (const auto& of : record.channels)
      for (const Finding& finding : of.findings)
        if (finding.kind == kind && of.name == channel) return &finding;
  return nullptr;
}

inline std::string all_of(const Report& report) {
  std::string text;
  for (const std::string& line : host_sim::data_check::lines_of(report, Weight::kInforms)) text += line + "\n";
  return text;
}

constexpr const char* kX1 = "displacement_1_m";
constexpr const char* kV1 = "velocity_1_m_s";
constexpr const char* kA1 = "acceleration_1_m_s2";
constexpr const char* kA2 = "acceleration_2_m_s2";

}  // namespace faults
