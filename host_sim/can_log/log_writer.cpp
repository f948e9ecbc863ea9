#include "host_sim/can_log/log_writer.hpp"

namespace can_log {

namespace {

std::string line_at(const hal::CanFrame& frame, std::string_view interface, uint64_t epoch_ns) {
  hal::CanFrame stamped = frame;
  stamped.time_ns += epoch_ns;
  return format_line(stamped, interface);
}

}  // namespace

std::string simulated_line(const hal::CanFrame& frame, std::string_view interface) {
  return line_at(frame, interface, kSimulatedEpoch_s * 1000000000u);
}

void LogWriter::write(const hal::CanFrame& frame) {
  output_ << line_at(frame, interface_, epoch_ns_) << '\n';
  ++frames_;
}

void LogWriter::write(const firmware::CanFrame& message, uint64_t time_ns) { write(to_frame(message, time_ns)); }

}  // namespace can_log
