#include "host_sim/data_check/time_base/jitter.hpp"

#include <fmt/format.h>

namespace host_sim::data_check {

std::optional<Finding> find_jitter(const Record& record) {
  if (!(record.time_jitter_s > 1e-3 * record.sample_period_s)) return std::nullopt;
  std::string text = fmt::format("the sample times scatter by {:.3g} us (rms) about even steps of {:.6g} us",
                                 record.time_jitter_s * 1e6, record.sample_period_s * 1e6);
  return Finding{"jitter", Weight::kInforms, "", text, record.time_jitter_s};
}

}  // namespace host_sim::data_check
