#include "hal/linux/store/file_configuration_store.hpp"

#include <cstring>

#include "firmware/configuration/bytes.hpp"

namespace hal {
namespace {

using firmware::crc32;
using firmware::get32;
using firmware::put32;

constexpr uint8_t kMagic[4] = {'R', 'I', 'G', 'C'};
constexpr size_t kHeader = 12, kTrailer = 4;
constexpr const char* kNew = "configuration.new";
constexpr const char* kNames[2] = {"configuration.0", "configuration.1"};

// Generations count on past 2^32; the later one is at most half the circle ahead.
bool later(uint32_t a, uint32_t b) { return static_cast<int32_t>(a - b) > 0; }

}  // namespace

FileConfigurationStore::Slot FileConfigurationStore::inspect(int index) {
  Slot slot;
  const size_t size = files_.read(kNames[index], image_, sizeof image_);
  if (size < kHeader + kTrailer || std::memcmp(image_, kMagic, sizeof kMagic) != 0) return slot;
  slot.generation = get32(image_ + 4);
  slot.size = get32(image_ + 8);
  slot.valid =
      slot.size == size - kHeader - kTrailer && get32(image_ + size - kTrailer) == crc32(image_, size - kTrailer);
  return slot;
}

size_t FileConfigurationStore::load(uint8_t* bytes, size_t capacity) {
  const Slot slots[2] = {inspect(0), inspect(1)};
  if (!slots[0].valid && !slots[1].valid) return 0;
  const int newest = slots[1].valid && (!slots[0].valid || later(slots[1].generation, slots[0].generation)) ? 1 : 0;
  const Slot slot = inspect(newest);
  if (!slot.valid || slot.size > capacity) return 0;
  std::memcpy(bytes, image_ + kHeader, slot.size);
  return slot.size;
}

bool FileConfigurationStore::save(const uint8_t* bytes, size_t size) {
  if (size == 0 || size > kCapacity) return false;
  const Slot slots[2] = {inspect(0), inspect(1)};
  uint32_t generation = 1;
  int target = 0;
  for (int i = 0; i < 2; ++i) {
    if (!slots[i].valid || (slots[1 - i].valid && !later(slots[i].generation, slots[1 - i].generation))) continue;
    generation = slots[i].generation + 1;
    target = 1 - i;
  }
  std::memcpy(image_, kMagic, sizeof kMagic);
  put32(image_ + 4, generation);
  put32(image_ + 8, static_cast<uint32_t>(size));
  std::memcpy(image_ + kHeader, bytes, size);
  put32(image_ + kHeader + size, crc32(image_, kHeader + size));

  bool good = files_.create(kNew) && files_.write(image_, kHeader + size + kTrailer) && files_.sync_file();
  good = files_.close() && good;
  return good && files_.rename(kNew, kNames[target]) && files_.sync_folder();
}

}  // namespace hal
