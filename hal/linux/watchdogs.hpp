// The two supervisors that a Linux board offers: systemd's (the unit's WatchdogSec) and the hardware's (/dev/watchdog).
#pragma once
#include <sys/socket.h>
#include <sys/un.h>

#include <string>

#include "hal/interface/watchdog.hpp"
#include "hal/linux/file_descriptor.hpp"

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

// The hardware watchdog. Once opened the board restarts unless it is fed; a clean end disarms it ("magic close").
class DeviceWatchdog final : public Watchdog {
 public:
  std::string open(const std::string& device, int timeout_s);  // empty where it worked
  void feed() override;
  void disarm();

 private:
  FileDescriptor device_;
};

// Feeds both.
class BoardWatchdog final : public Watchdog {
 public:
  BoardWatchdog(Watchdog& first, Watchdog* second) : first_(first), second_(second) {}
  void feed() override {
    first_.feed();
    if (second_ != nullptr) second_->feed();
  }

 private:
  Watchdog& first_;
  Watchdog* second_;
};

}  // namespace hal
