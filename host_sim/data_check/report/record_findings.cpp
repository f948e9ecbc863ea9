#include "host_sim/data_check/report/record_findings.hpp"

namespace host_sim::data_check {

void attach(std::vector<Finding> findings, RecordReport& report) {
  for (Finding& finding : findings) {
    const auto place = std::find_if(report.channels.begin(), report.channels.end(),
                                    [&](const ChannelReport& channel) { return channel.name == finding.channel; });
    (place == report.channels.end() ? report.findings : place->findings).push_back(std::move(finding));
  }
}

bool has_fault(const RecordReport& report, const char* kind) {
  return any_finding(
      report, [kind](const Finding& f) { return f.weight == Weight::kFault && (kind == nullptr || f.kind == kind); });
}

}  // namespace host_sim::data_check
