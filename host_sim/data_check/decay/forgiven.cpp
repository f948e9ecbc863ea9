#include "host_sim/data_check/decay/forgiven.hpp"

#include <algorithm>

#include "host_sim/data_check/channel/channel_report.hpp"
#include "host_sim/data_check/decay/release.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

// Whether a part of the record that estimate and diagnose keep has this fault too.
bool is_in(const std::vector<Record>& kept, const Finding& fault, const rig_file::RigModel* model) {
  return std::any_of(kept.begin(), kept.end(), [&](const Record& part) {
    const std::vector<Statistics> statistics = statistics_of(part);
    for (size_t i = 0; i < part.channels.size(); ++i)
      for (const Finding& finding : report_of(part, statistics, i, model).findings)
        if (finding.kind == fault.kind && finding.channel == fault.channel && finding.weight == Weight::kFault)
          return true;
    return false;
  });
}

}  // namespace

void forgive_what_is_left_out(const Record& record, const rig_file::RigModel* model, RecordReport& report) {
  std::vector<Record> kept = {record};
  if (keep_decays(kept).empty()) return;
  for (ChannelReport& channel : report.channels)
    for (Finding& finding : channel.findings)
      if (finding.weight == Weight::kFault && !is_in(kept, finding, model)) {
        finding.weight = Weight::kInforms;
        finding.detail += "; estimate and diagnose leave that part out";
      }
}

}  // namespace host_sim::data_check
