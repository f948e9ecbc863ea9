// A configuration store in memory: two slots written in turn on a medium that takes one byte at a time, so that the
// power can be cut at any byte. A slot counts only when its trailing check sum fits; the newer of two good slots is
// loaded.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hal/interface/configuration_store.hpp"

namespace hal {

class FakeConfigurationStore final : public ConfigurationStore {
 public:
  bool save(const uint8_t* bytes, size_t size) override;
  size_t load(uint8_t* bytes, size_t capacity) override;

  // Power goes after this many more written bytes; the write under way is left torn and save() answers false.
  void cut_power_after(size_t bytes) {
    bytes_left_ = bytes;
    cut_ = true;
  }
  void restore_power() { cut_ = false; }
  size_t written_bytes() const { return written_bytes_; }

 private:
  bool write(std::vector<uint8_t>& slot, size_t place, uint8_t byte);
  const std::vector<uint8_t>* newest() const;

  std::vector<uint8_t> slots_[2];  // generation (4 bytes), payload, check sum (4 bytes)
  size_t bytes_left_ = 0;
  bool cut_ = false;
  size_t written_bytes_ = 0;
};

}  // namespace hal
