// The command to the shaker amplifier.
#pragma once
#include <cstdint>

namespace hal {

class DriveOutput {
 public:
  // Signed full-scale fraction in Q0.31: the most negative int32 is -1. Takes effect before the next sample. False: not delivered.
  virtual bool write(int32_t drive_q31) = 0;

 protected:
  ~DriveOutput() = default;
};

}  // namespace hal
