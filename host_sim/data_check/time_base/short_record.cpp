#include "host_sim/data_check/time_base/short_record.hpp"

#include <fmt/format.h>

namespace host_sim::data_check {

std::optional<Finding> find_short(const Record& record) {
  constexpr size_t kFewest = 100;
  if (record.samples() >= kFewest) return std::nullopt;
  return Finding{"short", Weight::kFault, "",
                 fmt::format("holds {} samples, too few to answer from: record at least 128, several cycles of the "
                             "lowest frequency",
                             record.samples()),
                 static_cast<double>(record.samples())};
}

}  // namespace host_sim::data_check
