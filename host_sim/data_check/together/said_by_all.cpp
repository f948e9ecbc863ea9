#include "host_sim/data_check/together/said_by_all.hpp"

#include <algorithm>
#include <set>

namespace host_sim::data_check {

void keep_what_all_records_say(const char* kind, Report& report) {
  const auto is_kind = [kind](const Finding& f) { return f.kind == kind; };
  std::set<std::string> doubtful;  // channels of which some record does not say it
  for (const RecordReport& record : report.records)
    for (const ChannelReport& channel : record.channels)
      if (std::none_of(channel.findings.begin(), channel.findings.end(), is_kind)) doubtful.insert(channel.name);
  for (RecordReport& record : report.records)
    for (ChannelReport& channel : record.channels)
      if (doubtful.count(channel.name) > 0)
        channel.findings.erase(std::remove_if(channel.findings.begin(), channel.findings.end(), is_kind),
                               channel.findings.end());
}

}  // namespace host_sim::data_check
