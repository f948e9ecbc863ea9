#include "host_sim/records/derived/computed_anywhere.hpp"

#include <algorithm>
#include <map>

namespace host_sim {
namespace {

bool moves_without(const Channel& left_out, const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(), [&](const Channel& channel) {
    return channel.dof == left_out.dof && channel.quantity != Quantity::kForce && channel.name != left_out.name;
  });
}

}  // namespace

std::vector<LeftOutToo> leave_out_computed_anywhere(const std::vector<std::vector<Record>*>& all) {
  std::map<std::string, std::string> computed;  // name of the column, file that told it
  for (const std::vector<Record>* records : all)
    for (const Record& record : *records)
      for (const std::string& name : record.computed) computed.emplace(name, record.file);
  std::vector<LeftOutToo> told;
  for (std::vector<Record>* records : all)
    for (Record& record : *records)
      for (const auto& [name, file] : computed) {
        const auto channel = std::find_if(record.channels.begin(), record.channels.end(),
                                          [&](const Channel& one) { return one.name == name; });
        if (channel == record.channels.end() || !moves_without(*channel, record)) continue;
        record.channels.erase(channel);
        told.push_back({record.file, name + ": was computed from another column in " + file + ": left out here too"});
      }
  return told;
}

}  // namespace host_sim
