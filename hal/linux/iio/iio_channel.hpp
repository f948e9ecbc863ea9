// Which element of an IIO device feeds which channel of the rig, and where devices are found.
#pragma once
#include <cstdint>
#include <string>

#include "firmware/configuration/configuration.hpp"
#include "hal/linux/iio/iio_scan_format.hpp"

namespace hal {

struct IioChannel {
  std::string element;  // as sysfs names it, without ending: "in_voltage3", "in_accel_x"
  uint8_t node = 0;     // of the rig
  firmware::Quantity quantity = firmware::Quantity::kForce;
  bool rails_told = false;  // the board's file says where it saturates; else the driver's word width does
};

// The codes at which a converter saturates.
struct CodeRange {
  int32_t lowest = -firmware::kLargestCode;
  int32_t highest = firmware::kLargestCode;
  int dropped_bits = 0;  // a code is so many bits shorter than the converter's own
};

// Where the kernel keeps devices; other folders in tests.
struct IioRoots {
  std::string devices = "/sys/bus/iio/devices";
  std::string character_devices = "/dev";
};

// "iio:device0" for a device's own name ("ads8688") or for that; empty where there is none. Also finds triggers.
std::string find_iio_device(const IioRoots& roots, const std::string& name);
// What to say of one that is not there.
std::string not_found(const IioRoots& roots, const std::string& name);

// A rate as a driver reads it, Hz: "1000", "12.5". Many take no point at all, none more than six places.
std::string rate_text(double rate_Hz);
// What a driver says that it samples at is that rate, to 1e-4: the clocks of converters are as good. What is no number tells nothing.
bool is_rate(const std::string& told, double rate_Hz);

// Codes have up to 24 bits, with or without sign; wider samples are rounded to their upper 24 bits. A value that its own width
// cannot hold becomes the nearest that it can: a saturated one.
int32_t code_of(int64_t value, const ScanType& type);
CodeRange code_range(const ScanType& type);

}  // namespace hal
