#include "host_sim/ingestion/sensor_log/log_times.hpp"

#include <algorithm>

#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim {
namespace {

constexpr double kFallNow = 0.01;  // of the frames: a clock that is set back falls once
constexpr size_t kTell = 20;       // frames: fewer may bear one instant of a coarse clock
constexpr size_t kFirst = 2;       // steps on the way to a steady difference, as from the first frame's 0

}  // namespace

void LogTimes::learn(const can_log::LogEntry& entry) {
  if (!entry.has_time) return;
  const uint64_t now_ns = entry.frame.time_ns;
  if (frames_ > 0) rises_ += now_ns > last_ns_ ? 1 : 0, falls_ += now_ns < last_ns_ ? 1 : 0;
  if (frames_ == 0 || now_ns > latest_ns_) ++records_;
  ++frames_;
  last_ns_ = now_ns;
  latest_ns_ = std::max(latest_ns_, now_ns);
}

// A clock goes on. Differences either waver about one value, and seldom exceed all before, or are one and the same.
bool LogTimes::differences() const {
  if (frames_ < kTell) return false;
  if (rises_ <= kFirst) return falls_ <= kFirst;
  return static_cast<double>(falls_) > kFallNow * static_cast<double>(frames_) && records_ < falls_;
}

void LogTimes::require(const std::string& file, double sample_rate_Hz) const {
  if (sample_rate_Hz > 0.0 || tell()) return;
  throw DataFileError(
      file, 0,
      std::string(none() ? "the log has no times (candump without options writes none)"
                         : "the times of the frames are differences (candump -t d), which lines that are left out "
                           "falsify") +
          ", expected times as candump -L or candump -t a writes them, or --sample-rate with the samples per second");
}

}  // namespace host_sim
