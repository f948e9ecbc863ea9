// Non-volatile bytes. A save is atomic: after a power loss the old or the new content is there, never a mixture.
#pragma once
#include <cstddef>
#include <cstdint>

namespace hal {

class ConfigurationStore {
 public:
  virtual bool save(const uint8_t* bytes, size_t size) = 0;
  // Returns the number of bytes loaded, 0 where nothing valid is stored or capacity is too small.
  virtual size_t load(uint8_t* bytes, size_t capacity) = 0;

 protected:
  ~ConfigurationStore() = default;
};

}  // namespace hal
