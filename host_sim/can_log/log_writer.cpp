#include "host_sim/can_log/log_writer.hpp"

namespace can_log {

void LogWriter::write(const hal::CanFrame& frame) {
  hal::CanFrame stamped = frame;
  stamped.time_ns += epoch_ns_;
  output_ << format_line(stamped, interface_) << '\n';
  ++frames_;
}

void LogWriter::write(const firmware::CanMessage& message, uint64_t time_ns) { write(to_frame(message, time_ns)); }

}  // namespace can_log
