// The drive command to an IIO converter: out_voltageN_raw = zero_code + drive * full_scale_code.
#pragma once
#include <string>

#include "hal/interface/drive_output.hpp"
#include "hal/linux/iio/iio_channel.hpp"
#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

class IioDriveOutput final : public DriveOutput {
 public:
  struct Options {
    std::string device;   // name or iio:deviceN
    std::string element;  // "out_voltage0"
    int32_t zero_code = 0;
    int32_t full_scale_code = 32767;
  };
  std::string open(const Options& options, const IioRoots& roots = {});
  bool write(int32_t drive_q31) override;

 private:
  FileDescriptor file_;
  int32_t zero_code_ = 0;
  int32_t full_scale_code_ = 0;
};

// Where the drive command goes over CAN alone (the controller sends it) or there is no shaker.
class NoDriveOutput final : public DriveOutput {
 public:
  bool write(int32_t) override { return true; }
};

}  // namespace hal
