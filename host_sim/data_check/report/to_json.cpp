#include "host_sim/data_check/report/to_json.hpp"

#include <algorithm>

namespace host_sim::data_check {
namespace {

using nlohmann::ordered_json;

const char* word_of(Weight weight) {
  switch (weight) {
    case Weight::kInforms:
      return "informs";
    case Weight::kDoubt:
      return "doubt";
    case Weight::kFault:
      return "fault";
  }
  return "fault";
}

ordered_json json_of(const std::vector<Finding>& findings) {
  ordered_json list = ordered_json::array();
  for (const Finding& finding : findings) {
    ordered_json item = {{"kind", finding.kind}, {"detail", finding.detail}, {"weight", word_of(finding.weight)}};
    if (finding.value) item["value"] = *finding.value;
    list.push_back(std::move(item));
  }
  return list;
}

ordered_json json_of(const ChannelReport& channel) {
  return {{"name", channel.name},
          {"findings", json_of(channel.findings)},
          {"noise_floor", channel.noise_floor},
          {"rms", channel.rms},
          {"mean", channel.mean},
          {"resolution", channel.resolution}};
}

}  // namespace

ordered_json to_json(const Report& report) {
  ordered_json records = ordered_json::array();
  for (const RecordReport& record : report.records) {
    ordered_json channels = ordered_json::array();
    for (const ChannelReport& channel : record.channels) channels.push_back(json_of(channel));
    records.push_back({{"file", record.file},
                       {"samples", record.samples},
                       {"sample_rate_Hz", record.sample_rate_Hz},
                       {"channels", std::move(channels)},
                       {"findings", json_of(record.findings)}});
  }
  return {{"schema", "check/1"},
          {"records", std::move(records)},
          {"findings", json_of(report.findings)},
          {"verdict", report.verdict()}};
}

std::vector<std::string> lines_of(const Report& report, Weight least) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& front, const Finding& finding) {
    if (finding.weight < least) return;
    const std::string line = front + finding.kind + ": " + finding.detail;
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  };
  for (const RecordReport& record : report.records) {
    for (const Finding& finding : record.findings) add(record.file + ": ", finding);
    for (const ChannelReport& channel : record.channels)
      for (const Finding& finding : channel.findings) add(record.file + ": " + channel.name + ": ", finding);
  }
  for (const Finding& finding : report.findings) add("", finding);
  return lines;
}

}  // namespace host_sim::data_check
