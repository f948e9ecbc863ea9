// The findings of one record: put in their places, and looked through.
#pragma once
#include <algorithm>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// To the channels that they name, else to the record as a whole.
void attach(std::vector<Finding> findings, RecordReport& report);

template <typename Is>
bool any_finding(const RecordReport& report, Is is) {
  return std::any_of(report.findings.begin(), report.findings.end(), is) ||
         std::any_of(report.channels.begin(), report.channels.end(), [&](const ChannelReport& channel) {
           return std::any_of(channel.findings.begin(), channel.findings.end(), is);
         });
}

// Of that kind, or of any.
bool has_fault(const RecordReport& report, const char* kind = nullptr);

}  // namespace host_sim::data_check
