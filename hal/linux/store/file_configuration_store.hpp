// The configuration store in a folder: two files written in turn, each whole or not there, so that the one saved before
// is never touched while the next is written.
//
// A file: "RIGC", generation, payload size, payload, CRC-32 (as in zip) over all before it; numbers 32 bits,
// little-endian. A save writes configuration.new, syncs it, renames it over the older of configuration.0 and
// configuration.1 and syncs the folder. A load takes the valid file of the later generation. save() answers true only
// when the new content is durable.
#pragma once
#include <cstddef>
#include <cstdint>

#include "hal/interface/configuration_store.hpp"
#include "hal/linux/store/file_operations.hpp"

namespace hal {

class FileConfigurationStore final : public ConfigurationStore {
 public:
  explicit FileConfigurationStore(FileOperations& files) : files_(files) {}
  bool save(const uint8_t* bytes, size_t size) override;
  size_t load(uint8_t* bytes, size_t capacity) override;

 private:
  struct Slot {
    bool valid = false;
    uint32_t generation = 0;
    size_t size = 0;
  };
  Slot inspect(int index);  // leaves the file in image_

  FileOperations& files_;
  uint8_t image_[kCapacity + 16] = {};
};

}  // namespace hal
