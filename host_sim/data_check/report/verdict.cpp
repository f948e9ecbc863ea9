#include <algorithm>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

Weight Report::worst() const {
  Weight worst = Weight::kInforms;
  const auto take = [&worst](const std::vector<Finding>& list) {
    for (const Finding& finding : list) worst = std::max(worst, finding.weight);
  };
  take(findings);
  for (const RecordReport& record : records) {
    take(record.findings);
    for (const ChannelReport& channel : record.channels) take(channel.findings);
  }
  return worst;
}

const char* Report::verdict() const {
  switch (worst()) {
    case Weight::kInforms:
      return "good";
    case Weight::kDoubt:
      return "usable";
    case Weight::kFault:
      return "unusable";
  }
  return "unusable";
}

}  // namespace host_sim::data_check
