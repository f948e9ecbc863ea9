#include "host_sim/records/times/no_finer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim {

void require_no_finer(const std::vector<Record>& records, double rate_Hz) {
  constexpr double kFiner = 1.25;  // of uneven times the rate is about this or that
  const Record* fastest = nullptr;
  for (const Record& record : records) {
    if (record.own_step_s == 0.0) return;
    if (fastest == nullptr || record.own_step_s < fastest->own_step_s) fastest = &record;
  }
  if (fastest == nullptr || rate_Hz <= kFiner / fastest->own_step_s) return;
  throw DataFileError(fastest->file, 0,
                      fmt::format("has {0:.4g} samples a second; at {1:.4g} there would be interpolation alone between "
                                  "them, expected --resample {0:.4g}",
                                  1.0 / fastest->own_step_s, rate_Hz));
}

}  // namespace host_sim
