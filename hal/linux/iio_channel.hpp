// Which element of an IIO device feeds which channel of the rig, and where devices are found.
#pragma once
#include <cstdint>
#include <string>

#include "firmware/configuration/configuration.hpp"

namespace hal {

struct IioChannel {
  std::string element;  // as sysfs names it, without ending: "in_voltage3", "in_accel_x"
  uint8_t node = 0;     // of the rig
  firmware::Quantity quantity = firmware::Quantity::kForce;
};

// Where the kernel keeps devices; other folders in tests.
struct IioRoots {
  std::string devices = "/sys/bus/iio/devices";
  std::string character_devices = "/dev";
};

// "iio:device0" for a device's own name ("ads8688") or for that; empty where there is none. Also finds triggers.
std::string find_iio_device(const IioRoots& roots, const std::string& name);

// Codes are up to 24 bits with sign; wider samples keep their upper 24 bits.
int32_t code_of(int64_t value, int bits);

}  // namespace hal
