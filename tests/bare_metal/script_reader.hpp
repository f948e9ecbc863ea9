// Reads a script (script.hpp) event by event.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "tests/bare_metal/script.hpp"

namespace bare_metal {

class ScriptReader {
 public:
  explicit ScriptReader(Bytes& bytes) : bytes_(bytes) {}
  bool read(firmware::ControllerConfiguration& configuration);  // first
  bool next(uint8_t& event) { return take(event); }
  // Its codes; the channels that are not there stay 0.
  bool read(const firmware::ControllerConfiguration& configuration, firmware::RawSample& sample);

 private:
  bool take(uint8_t& byte);
  bool take(uint32_t& value);

  Bytes& bytes_;
  uint8_t buffer_[1024];
  size_t size_ = 0, at_ = 0;
  uint8_t configuration_bytes_[firmware::kConfigurationBytes];
};

}  // namespace bare_metal
