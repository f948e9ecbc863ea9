// Where the frames of a run go: a candump log in a file or on stdout, or a real bus.
#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "hal/interface/can_bus.hpp"
#include "host_sim/records/files/output_file.hpp"

namespace host_sim {

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void write(const hal::CanFrame& frame) = 0;  // at frame.time_ns of simulated time
  virtual void until(uint64_t /*time_ns*/) {}          // simulated time goes on to here
  virtual void commit() {}                             // the run is complete
};

std::unique_ptr<FrameSink> log_file_sink(const std::string& path, const std::string& interface);
std::unique_ptr<FrameSink> stdout_sink(const std::string& interface);
// Keeps simulated time in step with the wall clock. Throws UsageError, naming the --log way, where the kernel has no
// such interface.
std::unique_ptr<FrameSink> socket_can_sink(const std::string& interface);

}  // namespace host_sim
