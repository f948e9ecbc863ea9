// IIO devices made of folders, files and a pipe: what the kernel shows of a driver.
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hal/linux/iio/iio_buffer_source.hpp"
#include "hal/linux/system/monotonic_clock.hpp"
#include "hal/linux/system/sysfs.hpp"

namespace iio_test {

struct TestClock final : hal::MonotonicClock {
  uint64_t now_ns() override { return time_ns; }
  uint64_t time_ns = 0;
};

class IioDevice : public testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/iio_test_XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    root_ = folder;
    roots_.devices = root_ + "/devices";
    roots_.character_devices = root_ + "/dev";
    std::filesystem::create_directories(roots_.character_devices);
    put("iio:device0/name", "thermometer");
    put("iio:device1/name", "adc16");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void put(const std::string& path, const std::string& text) {
    const std::filesystem::path full = roots_.devices + "/" + path;
    std::filesystem::create_directories(full.parent_path());
    std::ofstream(full) << text;
  }
  std::string get(const std::string& path) const { return hal::read_text(roots_.devices + "/iio:device1/" + path); }

  // A converter with two 16-bit channels, a temperature that nobody wants, and time stamps.
  void add_buffer() {
    const struct {
      const char* name;
      const char* index;
      const char* type;
    } elements[] = {{"in_voltage0", "0", "be:s16/16>>0"},
                    {"in_voltage1", "1", "be:s16/16>>0"},
                    {"in_temp", "2", "be:u12/16>>0"},
                    {"in_timestamp", "3", "le:s64/64>>0"}};
    for (const auto& element : elements) {
      const std::string base = std::string("iio:device1/scan_elements/") + element.name;
      put(base + "_en", "1");
      put(base + "_index", element.index);
      put(base + "_type", element.type);
    }
    put("iio:device1/buffer/enable", "0");
    put("iio:device1/buffer/length", "");
    put("iio:device1/trigger/current_trigger", "");
    put("iio:device1/sampling_frequency", "");
    put("iio:device1/current_timestamp_clock", "realtime");
    const std::string pipe = roots_.character_devices + "/iio:device1";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    pipe_ = hal::FileDescriptor(::open(pipe.c_str(), O_RDWR));
  }
  // Voltage 0, voltage 1, four bytes of filling, stamp.
  void deliver(int16_t v0, int16_t v1, uint64_t stamp_ns) {
    uint8_t scan[16] = {};
    scan[0] = static_cast<uint8_t>(v0 >> 8);
    scan[1] = static_cast<uint8_t>(v0);
    scan[2] = static_cast<uint8_t>(v1 >> 8);
    scan[3] = static_cast<uint8_t>(v1);
    for (int i = 0; i < 8; ++i) scan[8 + i] = static_cast<uint8_t>(stamp_ns >> (8 * i));
    ASSERT_EQ(::write(pipe_.get(), scan, sizeof scan), 16);
  }

  std::string root_;
  hal::IioRoots roots_;
  TestClock clock_;
  hal::FileDescriptor pipe_;
  const std::vector<hal::IioChannel> channels_ = {{"in_voltage1", 0, firmware::Quantity::kForce},
                                                  {"in_voltage0", 2, firmware::Quantity::kDisplacement}};
};

}  // namespace iio_test
