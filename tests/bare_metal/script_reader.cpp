#include "tests/bare_metal/script_reader.hpp"

namespace bare_metal {

bool ScriptReader::take(uint8_t& byte) {
  if (at_ == size_) {
    at_ = 0;
    size_ = bytes_.read(buffer_, sizeof buffer_);
    if (size_ == 0) return false;
  }
  byte = buffer_[at_++];
  return true;
}

bool ScriptReader::take(uint32_t& value) {
  value = 0;
  for (int i = 0; i < 4; ++i) {
    uint8_t byte = 0;
    if (!take(byte)) return false;
    value |= static_cast<uint32_t>(byte) << (8 * i);
  }
  return true;
}

bool ScriptReader::read(firmware::ControllerConfiguration& configuration) {
  for (const char* mark = "RIG1"; *mark != 0; ++mark) {
    uint8_t byte = 0;
    if (!take(byte) || byte != static_cast<uint8_t>(*mark)) return false;
  }
  uint32_t length = 0;
  if (!take(length) || length > sizeof configuration_bytes_) return false;
  for (uint32_t i = 0; i < length; ++i)
    if (!take(configuration_bytes_[i])) return false;
  return firmware::decode(configuration_bytes_, length, configuration);
}

bool ScriptReader::read(const firmware::ControllerConfiguration& configuration, firmware::RawSample& sample) {
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int quantity = 0; quantity < firmware::kQuantities; ++quantity) {
      if (!configuration.core.channels[node][quantity].present) continue;
      uint32_t code = 0;
      if (!take(code)) return false;
      sample.code[node][quantity] = static_cast<int32_t>(code);
    }
  return true;
}

}  // namespace bare_metal
