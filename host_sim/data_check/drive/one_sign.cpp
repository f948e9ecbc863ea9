#include "host_sim/data_check/drive/one_sign.hpp"

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

}  // namespace

void require_one_sign(Report& report) {
  for (const ChannelReport& channel : report.records.front().channels) {
    const std::vector<Finding*> list = turned_over(report, channel.name);
    if (list.size() == report.records.size()) continue;
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
