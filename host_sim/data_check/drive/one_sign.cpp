#include "host_sim/data_check/drive/one_sign.hpp"

#include <algorithm>

namespace host_sim::data_check {
namespace {

// The findings of a single force that is turned over, one of each record that says so.
std::vector<Finding*> turned_over(Report& report, const std::string& name) {
  std::vector<Finding*> list;
  for (RecordReport& record : report.records)
    for (ChannelReport& channel : record.channels)
      for (Finding& finding : channel.findings)
        if (channel.name == name && finding.kind == "polarity" && finding.weight == Weight::kDoubt)
          list.push_back(&finding);
  return list;
}

constexpr size_t kTooShort = 4;  // times shorter than one that says it: two deviations are one then, and say nothing

bool says_so(const RecordReport& record, const std::string& name) {
  Report one;
  one.records = {record};
  return !turned_over(one, name).empty();
}

}  // namespace

void require_one_sign(Report& report) {
  for (const ChannelReport& channel : report.records.front().channels) {
    const std::vector<Finding*> list = turned_over(report, channel.name);
    size_t longest = 0;
    for (const RecordReport& record : report.records)
      if (says_so(record, channel.name)) longest = std::max(longest, record.samples);
    const bool agreed = std::all_of(report.records.begin(), report.records.end(), [&](const RecordReport& record) {
      return record.samples * kTooShort < longest || says_so(record, channel.name);
    });
    if (agreed) continue;
    for (Finding* finding : list) finding->weight = Weight::kFault, finding->detail += "; other records say otherwise";
  }
}

bool turn_over(Report report, std::vector<Record>& records) {
  bool any = false;
  for (size_t c = 0; !records.empty() && c < records.front().channels.size(); ++c) {
    if (turned_over(report, records.front().channels[c].name).empty()) continue;
    any = true;
    for (Record& record : records)
      for (double& value : record.channels[c].values) value = -value;
  }
  return any;
}

}  // namespace host_sim::data_check
