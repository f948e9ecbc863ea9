#include "lone_channel.hpp"

#include <algorithm>

namespace diagnosis {

std::vector<std::string> spared_by_others(const host_sim::Record& record, host_sim::Quantity quantity) {
  std::vector<std::string> names;
  for (const host_sim::Channel& c : record.channels) {
    const auto another = [&](const host_sim::Channel& o) {
      return o.dof == c.dof && o.quantity != quantity && o.quantity != host_sim::Quantity::kForce;
    };
    if (c.dof >= 1 && c.quantity == quantity && std::any_of(record.channels.begin(), record.channels.end(), another))
      names.push_back(c.name);
  }
  return names;
}

std::vector<host_sim::Record> without_channels(std::vector<host_sim::Record> records,
                                               const std::vector<std::string>& names) {
  for (host_sim::Record& record : records)
    record.channels.erase(std::remove_if(record.channels.begin(), record.channels.end(),
                                         [&](const host_sim::Channel& c) {
                                           return std::find(names.begin(), names.end(), c.name) != names.end();
                                         }),
                          record.channels.end());
  return records;
}

}  // namespace diagnosis
