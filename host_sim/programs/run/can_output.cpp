#include "host_sim/programs/run/can_output.hpp"

#include <chrono>
#include <cstdio>
#include <thread>

#include "hal/linux/can/socket_can.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/programs/shared/failures.hpp"

namespace host_sim {
namespace {

class LogFileSink : public FrameSink {
 public:
  LogFileSink(const std::string& path, const std::string& interface) : file_(path), interface_(interface) {}
  void write(const hal::CanFrame& frame) override { file_.write(can_log::simulated_line(frame, interface_) + "\n"); }
  void commit() override { file_.commit(); }

 private:
  OutputFile file_;
  std::string interface_;
};

class StdoutSink : public FrameSink {
 public:
  explicit StdoutSink(const std::string& interface) : interface_(interface) {}
  void write(const hal::CanFrame& frame) override { std::puts(can_log::simulated_line(frame, interface_).c_str()); }
  void commit() override {
    if (std::fflush(stdout) != 0) throw OutputError("stdout: cannot be written, expected a reader");
  }

 private:
  std::string interface_;
};

class SocketCanSink : public FrameSink {
 public:
  explicit SocketCanSink(const std::string& interface) : start_(std::chrono::steady_clock::now()) {
    const std::string fault = bus_.open(interface, {});
    if (!fault.empty())
      throw UsageError("--can " + interface + ": " + fault +
                       "; without CAN, --log FILE (or --log -) gives the same frames as a candump log");
  }
  // A full queue empties at the bus's own pace; a frame that still does not fit after a second is a bus that does not
  // run.
  void write(const hal::CanFrame& frame) override {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const hal::CanResult result = bus_.send(frame);
      if (result == hal::CanResult::kDone) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    throw UsageError(
        "--can: the bus takes no frames, expected an interface that is up and another node that acknowledges");
  }
  void until(uint64_t time_ns) override { std::this_thread::sleep_until(start_ + std::chrono::nanoseconds(time_ns)); }

 private:
  hal::SocketCan bus_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

std::unique_ptr<FrameSink> log_file_sink(const std::string& path, const std::string& interface) {
  return std::make_unique<LogFileSink>(path, interface);
}
std::unique_ptr<FrameSink> stdout_sink(const std::string& interface) { return std::make_unique<StdoutSink>(interface); }
std::unique_ptr<FrameSink> socket_can_sink(const std::string& interface) {
  return std::make_unique<SocketCanSink>(interface);
}

}  // namespace host_sim
