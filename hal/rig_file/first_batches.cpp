#include "hal/rig_file/first_batches.hpp"

#include "firmware/configuration/capacity.hpp"

namespace rig_file {
namespace {

constexpr uint32_t kShortest = 32;
// Estimates are wanted while a level is long from over: a level at 1 kHz has 7 of them after its first second.
constexpr uint32_t kLongest = 128;
// What the core takes of a level for context (filters of 57 and 25 taps, margins) is less than two batches of 64.
constexpr uint64_t kMargins = 2;

}  // namespace

uint32_t first_batch_samples(uint64_t level_samples) {
  uint32_t length = kShortest;
  // More than a table of half as long ones holds: those would have merged.
  while (length < kLongest && level_samples >= 2 * length * (uint64_t{firmware::kMaxBatches} / 2 + kMargins))
    length *= 2;
  return length == kShortest ? 0 : length;
}

}  // namespace rig_file
