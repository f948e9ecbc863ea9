// Non-volatile bytes. A save is atomic: after a power loss the old or the new content is there, never a mixture.
#pragma once
#include <cstddef>
#include <cstdint>

namespace hal {

class ConfigurationStore {
 public:
  // Every store takes and gives back this much; whoever stores something proves while compiling that it is no longer.
  static constexpr size_t kCapacity = 28672;

  // May take as long as the medium does: not to be called between samples (Ports::store_worker). False: not saved, and
  // what was stored before is still there.
  virtual bool save(const uint8_t* bytes, size_t size) = 0;
  // Returns the number of bytes loaded, 0 where nothing valid is stored or capacity is too small.
  virtual size_t load(uint8_t* bytes, size_t capacity) = 0;

 protected:
  ~ConfigurationStore() = default;
};

}  // namespace hal
