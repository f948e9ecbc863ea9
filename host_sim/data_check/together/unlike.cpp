#include "host_sim/data_check/together/unlike.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

// With commas between.
std::string names_of(const std::vector<const Channel*>& channels) {
  std::string names;
  for (const Channel* channel : channels) names += (names.empty() ? "" : ", ") + channel->name;
  return names;
}

Finding told(const std::string& text) { return {"unlike", Weight::kDoubt, "", text, std::nullopt}; }

}  // namespace

std::vector<Finding> find_unlike(const std::vector<Record>& records) {
  std::vector<Finding> findings;
  for (const Record& record : records) {
    const Record& first = records.front();
    if (!same_period(record, first))
      findings.push_back(told(fmt::format(
          "{} has {:.6g} samples a second, {} {:.6g}: estimate and diagnose take both together with --resample {:.4g}",
          record.file, 1.0 / record.sample_period_s, first.file, 1.0 / first.sample_period_s,
          1.0 / std::min(record.sample_period_s, first.sample_period_s))));
    const std::string lacks = names_of(channels_beyond(first, record)), has = names_of(channels_beyond(record, first));
    if (lacks.empty() && has.empty()) continue;
    findings.push_back(told(fmt::format(
        "{}{}{}{}{}, against {}: estimate and diagnose take records of the same channels together (--column CHANNEL= "
        "leaves one out)",
        record.file, lacks.empty() ? "" : " lacks ", lacks,
        has.empty()     ? ""
        : lacks.empty() ? " has "
                        : " and has ",
        has, first.file)));
  }
  return findings;
}

}  // namespace host_sim::data_check
