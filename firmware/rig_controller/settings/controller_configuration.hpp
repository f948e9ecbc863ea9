// Everything that the controller is told at start, as plain integers, and its form in bytes: for the configuration
// store and for the check sum in the identity frame, the same on every machine.
#pragma once
#include <cstddef>
#include <cstdint>

#include "firmware/configuration/configuration.hpp"
#include "firmware/excitation/programme.hpp"
#include "firmware/supervision/supervisor.hpp"
#include "hal/interface/configuration_store.hpp"

namespace firmware {

// The estimates once more as 32-bit floats, for tools that plot them from a DBC.
enum class FloatEstimates : uint8_t { kWhereLoadAllows = 0, kAlways = 1, kNever = 2 };

struct NodeConfiguration {
  uint8_t node = 1;     // 1 to 7
  bool can_fd = false;  // estimates in CAN FD frames
  FloatEstimates float_estimates = FloatEstimates::kWhereLoadAllows;
  bool sync_closes_window = true;  // SYNC frame and sync edge
  bool listen_on_command = false;  // without a programme: a level lasts from start to stop, not from the first sample
  bool drive_on_can = false;       // the drive command is also sent as a frame, each sample
  uint16_t heartbeat_ms = 100;     // 0: none
  uint16_t status_ms = 100;
  uint16_t emergency_inhibit_ms = 100;  // between two emergency frames
  uint32_t window_samples = 1000;       // samples from one set of estimates to the next, 50 to 1000 ms
  uint32_t rotating_nodes = 0;          // bit i: DOF i rotates (names and units on the bus)
};

struct ControllerConfiguration {
  CoreConfiguration core;
  ExcitationProgramme programme;
  NodeConfiguration node;
  LimitConfiguration limits;
};

// Whether the estimates go out as floats too: as the node is told, or where their load allows (estimate_frames.hpp).
bool sends_float_estimates(const ControllerConfiguration& configuration);

// Little-endian fields one after another, then their CRC-32 (polynomial 0xEDB88320): no padding, no host layout.
// What is in use alone is stored, and numbered as in the largest core (capacity.hpp): the bytes do not depend on the capacity
// of the core that wrote them.
constexpr size_t kNodeBytes =
    kQuantities * (29 + 18 + 4 * (2 * kFilterHalf + 1)) + 2 + 4 * (2 * kFusionHalf + 1) + 124 + 156;
constexpr size_t kAllBytes = 384 + kMaxNodes * kNodeBytes + kMaxLinks * 2 + kMaxTerms * 31 + kMaxLevels * 48;
// The longest fits; encode() says how many are used.
constexpr size_t kConfigurationBytes =
    kAllBytes < hal::ConfigurationStore::kCapacity ? kAllBytes : hal::ConfigurationStore::kCapacity;

// Returns the bytes written.
size_t encode(const ControllerConfiguration& configuration, uint8_t (&bytes)[kConfigurationBytes]);
// False where version, CRC or length do not fit. Where version or CRC do not, configuration is untouched.
bool decode(const uint8_t* bytes, size_t size, ControllerConfiguration& configuration);

enum class Stored : uint8_t { kDamaged, kOfAnotherRig, kOfThisRig };
// What encode() wrote, read beside the configuration in use. Rig, programme and limits the same: node is what was stored
// for it; else node is untouched.
Stored read_stored(const uint8_t* bytes, size_t size, const ControllerConfiguration& own, NodeConfiguration& node);

// The CRC of encode().
uint32_t configuration_crc(const ControllerConfiguration& configuration);

}  // namespace firmware
