#include "host_sim/data_check/between_dofs/duplicate.hpp"

#include <fmt/format.h>

namespace host_sim::data_check {
namespace {

constexpr size_t kFewestChanges = 20;

size_t changes_of(const std::vector<double>& values) {
  size_t changes = 0;
  for (size_t i = 1; i < values.size(); ++i) changes += values[i] != values[i - 1] ? 1 : 0;
  return changes;
}

}  // namespace

std::vector<Finding> find_duplicates(const Record& record) {
  std::vector<Finding> findings;
  for (size_t later = 1; later < record.channels.size(); ++later) {
    const Channel& channel = record.channels[later];
    if (channel.quantity == Quantity::kForce) continue;  // one command may go to two drives
    for (size_t i = 0; i < later; ++i) {
      const Channel& first = record.channels[i];
      if (first.quantity != channel.quantity || first.values != channel.values) continue;
      if (changes_of(channel.values) < kFewestChanges) continue;
      findings.push_back({"duplicate", Weight::kFault, channel.name,
                          fmt::format("holds the very samples of {}: one of the two is not what its name says (a "
                                      "column copied, a sensor wired twice)",
                                      first.name),
                          std::nullopt});
      break;
    }
  }
  return findings;
}

}  // namespace host_sim::data_check
