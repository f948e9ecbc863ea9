// The two supervisors that a Linux board offers: systemd's (the unit's WatchdogSec) and the hardware's (/dev/watchdog).
#pragma once
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdint>
#include <string>

#include "hal/interface/clock.hpp"
#include "hal/interface/watchdog.hpp"
#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

// Speaks systemd's notify protocol: plain datagrams to the socket named by NOTIFY_SOCKET. Silent where that is not set.
class SystemdWatchdog final : public Watchdog {
 public:
  // address: the value of NOTIFY_SOCKET, may be null; a leading '@' is an abstract socket.
  explicit SystemdWatchdog(const char* address);

  bool present() const { return static_cast<bool>(socket_); }
  void ready();     // start-up is over
  void stopping();  // the program ends on purpose
  void status(const char* text);
  void feed() override;

 private:
  void notify(const char* state);
  FileDescriptor socket_;
  sockaddr_un address_{};
  socklen_t address_size_ = 0;
};

// The device that a board's file means: "auto" is the hardware's first watchdog where there is one that can be disarmed,
// "none" is none. Empty: none.
std::string watchdog_device(const std::string& setting);
// Counts down at this moment, for whoever opened it; true where the kernel does not tell.
bool watchdog_is_armed(const std::string& device);

// The hardware watchdog. Once opened the board restarts unless it is fed; a clean end disarms it ("magic close").
class DeviceWatchdog final : public Watchdog {
 public:
  // Empty where it worked; else what is wrong, and the watchdog is disarmed again.
  std::string open(const std::string& device, int timeout_s);
  bool present() const { return static_cast<bool>(device_); }
  void feed() override;
  void disarm();

 private:
  FileDescriptor device_;
};

// Feeds both, ten times a second: each feed of systemd's wakes its process.
class BoardWatchdog final : public Watchdog {
 public:
  static constexpr uint64_t kPeriod_ns = 100000000;
  BoardWatchdog(MonotonicClock& clock, Watchdog& first, Watchdog& second)
      : clock_(clock), first_(first), second_(second) {}
  void feed() override;

 private:
  MonotonicClock& clock_;
  Watchdog& first_;
  Watchdog& second_;
  uint64_t next_ns_ = 0;
};

}  // namespace hal
