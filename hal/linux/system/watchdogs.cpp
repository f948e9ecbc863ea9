#include "hal/linux/system/watchdogs.hpp"

#include <errno.h>
#include <fcntl.h>
#include <linux/watchdog.h>
#include <sys/ioctl.h>

#include <cstddef>
#include <cstdio>
#include <cstring>

#include "hal/linux/system/sysfs.hpp"

namespace hal {
namespace {

// Of the watchdog's folder in sysfs; empty where there is none.
std::string attribute_of(const std::string& device, const char* name) {
  return read_text("/sys/class/watchdog/" + device.substr(device.rfind('/') + 1) + "/" + name);
}

}  // namespace

SystemdWatchdog::SystemdWatchdog(const char* address) {
  if (address == nullptr || (address[0] != '/' && address[0] != '@')) return;
  const size_t length = std::strlen(address);
  if (length < 2 || length >= sizeof address_.sun_path) return;
  address_.sun_family = AF_UNIX;
  std::memcpy(address_.sun_path, address, length);
  if (address[0] == '@') address_.sun_path[0] = '\0';
  address_size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
  socket_ = FileDescriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
}

void SystemdWatchdog::notify(const char* state) {
  if (!socket_) return;
  ::sendto(socket_.get(), state, std::strlen(state), MSG_DONTWAIT | MSG_NOSIGNAL,
           reinterpret_cast<const sockaddr*>(&address_), address_size_);
}

void SystemdWatchdog::ready() { notify("READY=1"); }
void SystemdWatchdog::stopping() { notify("STOPPING=1"); }
void SystemdWatchdog::feed() { notify("WATCHDOG=1"); }

void SystemdWatchdog::status(const char* text) {
  char message[256];
  std::snprintf(message, sizeof message, "STATUS=%s", text);
  notify(message);
}

std::string watchdog_device(const std::string& setting) {
  if (setting == "none") return "";
  if (setting != "auto") return setting;
  const std::string device = "/dev/watchdog0";
  // One that nobody can disarm would reset the board whenever the program is stopped: that is for the file to ask for.
  return file_exists(device) && attribute_of(device, "nowayout") != "1" ? device : "";
}

bool watchdog_is_armed(const std::string& device) { return attribute_of(device, "state") != "inactive"; }

std::string DeviceWatchdog::open(const std::string& device, int timeout_s) {
  device_ = FileDescriptor(::open(device.c_str(), O_WRONLY | O_CLOEXEC));
  if (!device_) return "watchdog " + device + ": " + std::strerror(errno);
  if (::ioctl(device_.get(), WDIOC_SETTIMEOUT, &timeout_s) == 0) return "";
  const std::string fault =
      "watchdog " + device + " does not take a time of " + std::to_string(timeout_s) + " s: " + std::strerror(errno);
  disarm();
  return fault;
}

void DeviceWatchdog::feed() {
  if (device_) static_cast<void>(!::write(device_.get(), "k", 1));
}

void DeviceWatchdog::disarm() {
  if (device_) static_cast<void>(!::write(device_.get(), "V", 1));
  device_.reset();
}

void BoardWatchdog::feed() {
  const uint64_t now_ns = clock_.now_ns();
  if (now_ns < next_ns_) return;
  next_ns_ = now_ns + kPeriod_ns;
  first_.feed();
  second_.feed();
}

}  // namespace hal
