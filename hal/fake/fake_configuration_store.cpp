// See fake_configuration_store.hpp.
#include "hal/fake/fake_configuration_store.hpp"

#include <algorithm>

#include "firmware/configuration/bytes.hpp"

namespace hal {
namespace {

constexpr size_t kFrameBytes = 8;  // generation and check sum

using firmware::get32;

void append32(std::vector<uint8_t>& bytes, uint32_t value) {
  bytes.resize(bytes.size() + 4);
  firmware::put32(bytes.data() + bytes.size() - 4, value);
}

bool good(const std::vector<uint8_t>& slot) {
  return slot.size() > kFrameBytes &&
         firmware::crc32(slot.data(), slot.size() - 4) == get32(slot.data() + slot.size() - 4);
}

}  // namespace

const std::vector<uint8_t>* FakeConfigurationStore::newest() const {
  const bool first = good(slots_[0]);
  const bool second = good(slots_[1]);
  if (!first && !second) return nullptr;
  if (first && second) return get32(slots_[0].data()) > get32(slots_[1].data()) ? &slots_[0] : &slots_[1];
  return first ? &slots_[0] : &slots_[1];
}

bool FakeConfigurationStore::write(std::vector<uint8_t>& slot, size_t place, uint8_t byte) {
  if (cut_) {
    if (bytes_left_ == 0) return false;
    --bytes_left_;
  }
  if (place >= slot.size()) slot.resize(place + 1, 0xFF);
  slot[place] = byte;
  ++written_bytes_;
  return true;
}

bool FakeConfigurationStore::save(const uint8_t* bytes, size_t size) {
  if (size == 0 || size > kCapacity) return false;
  const std::vector<uint8_t>* present = newest();
  std::vector<uint8_t>& slot = present == &slots_[0] ? slots_[1] : slots_[0];
  std::vector<uint8_t> image;
  append32(image, present ? get32(present->data()) + 1 : 1);
  image.insert(image.end(), bytes, bytes + size);
  append32(image, firmware::crc32(image.data(), image.size()));
  for (size_t i = 0; i < image.size(); ++i)
    if (!write(slot, i, image[i])) return false;
  slot.resize(image.size());
  return true;
}

size_t FakeConfigurationStore::load(uint8_t* bytes, size_t capacity) {
  const std::vector<uint8_t>* slot = newest();
  if (slot == nullptr || slot->size() - kFrameBytes > capacity) return 0;
  std::copy(slot->begin() + 4, slot->end() - 4, bytes);
  return slot->size() - kFrameBytes;
}

}  // namespace hal
