// The words that systemd waits for, read from a socket in its place.
#include "hal/linux/system/watchdogs.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

struct Listener {
  explicit Listener(const std::string& name) : path(name) {
    socket = hal::FileDescriptor(::socket(AF_UNIX, SOCK_DGRAM, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.data(), path.size());
    if (path[0] == '@') address.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
    bound = ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), size) == 0;
  }
  std::string next() const {
    char text[256];
    const ssize_t size = ::recv(socket.get(), text, sizeof text, MSG_DONTWAIT);
    return size < 0 ? "nothing" : std::string(text, static_cast<size_t>(size));
  }
  std::string path;
  hal::FileDescriptor socket;
  bool bound = false;
};

void speaks_the_protocol_at(const std::string& address) {
  const Listener systemd(address);
  ASSERT_TRUE(systemd.bound) << address;
  hal::SystemdWatchdog watchdog(address.c_str());
  ASSERT_TRUE(watchdog.present());
  watchdog.ready();
  watchdog.feed();
  watchdog.status("level 2 of 3");
  watchdog.stopping();
  EXPECT_EQ(systemd.next(), "READY=1");
  EXPECT_EQ(systemd.next(), "WATCHDOG=1");
  EXPECT_EQ(systemd.next(), "STATUS=level 2 of 3");
  EXPECT_EQ(systemd.next(), "STOPPING=1");
  EXPECT_EQ(systemd.next(), "nothing");
}

TEST(SystemdWatchdog, SpeaksToASocketInTheFileSystem) {
  char folder[] = "/tmp/watchdog_test_XXXXXX";
  ASSERT_NE(mkdtemp(folder), nullptr);
  speaks_the_protocol_at(std::string(folder) + "/notify");
  EXPECT_EQ(std::system(("rm -r " + std::string(folder)).c_str()), 0);
}

TEST(SystemdWatchdog, SpeaksToAnAbstractSocket) {
  speaks_the_protocol_at("@watchdog_test_" + std::to_string(::getpid()));
}

TEST(SystemdWatchdog, IsSilentOutsideSystemd) {
  for (const char* address : {static_cast<const char*>(nullptr), "", "relative/path"}) {
    hal::SystemdWatchdog watchdog(address);
    EXPECT_FALSE(watchdog.present());
    watchdog.ready();
    watchdog.feed();
  }
}

TEST(DeviceWatchdog, SaysWhatIsMissing) {
  hal::DeviceWatchdog watchdog;
  EXPECT_NE(watchdog.open("/dev/no_such_watchdog", 2).find("/dev/no_such_watchdog"), std::string::npos);
  watchdog.feed();
  watchdog.disarm();
}

}  // namespace
