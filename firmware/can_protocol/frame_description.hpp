// The words in which frame_table.hpp describes a frame: where its identifiers lie and which bits mean what.
// All signals are little-endian integers; physical value = raw * factor_numerator / factor_denominator + offset.
#pragma once
#include <cstddef>
#include <cstdint>

namespace firmware {
namespace can {

constexpr int kFirstNode = 1;
constexpr int kLastNode = 7;

struct NamedValue {
  int32_t value;  // of the raw signal; the bit number in a table of flags
  const char* name;
};

struct ValueTable {
  const NamedValue* entries = nullptr;
  uint8_t count = 0;
  bool flags = false;  // entries name single bits, any number of which may be set
};

template <size_t N>
constexpr ValueTable states(const NamedValue (&entries)[N]) {
  return ValueTable{entries, static_cast<uint8_t>(N), false};
}
template <size_t N>
constexpr ValueTable flags(const NamedValue (&entries)[N]) {
  return ValueTable{entries, static_cast<uint8_t>(N), true};
}

struct Signal {
  const char* name;
  uint16_t start_bit;  // of the least significant bit, counted from bit 0 of byte 0
  uint8_t length;      // bits, 1 to 32
  bool is_signed;
  int32_t factor_numerator;
  int32_t factor_denominator;
  int32_t offset;
  const char* unit;  // "1" for pure numbers, "state" and "flags" where names follow, "hex" for bit patterns
  ValueTable names;
  const char* comment;
};

constexpr int64_t lowest_raw(const Signal& signal) {
  return signal.is_signed ? -(int64_t{1} << (signal.length - 1)) : 0;
}
// A signal has 1 to 32 bits (frame_plan_check.hpp).
constexpr int64_t highest_raw(const Signal& signal) {
  // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult)
  return (int64_t{1} << (signal.is_signed ? signal.length - 1 : signal.length)) - 1;
}

// The identifiers of a kind of frame: one per node (node_stride > 0) or one set for the whole rig (node_stride = 0),
// and in each of these `members` identifiers, laid in banks:
//   id(node, member) = base + node_stride * node + bank_offset[member / bank_members] + member % bank_members
struct IdPlan {
  uint16_t base;
  uint8_t node_stride = 1;
  uint8_t members = 1;
  uint8_t bank_members = 32;
  uint16_t bank_offset[3] = {0, 32, 64};
};

constexpr int bank_count(const IdPlan& plan) { return (plan.members + plan.bank_members - 1) / plan.bank_members; }

constexpr uint32_t frame_id(const IdPlan& plan, int node, int member = 0) {
  return static_cast<uint32_t>(plan.base + plan.node_stride * node + plan.bank_offset[member / plan.bank_members] +
                               member % plan.bank_members);
}

enum class Sender : uint8_t { kController, kSensor, kMaster };

struct FrameDescription {
  const char* name;
  IdPlan ids;
  Sender sender;
  uint16_t cycle_ms;  // 0: on the event; where the period is configurable, its usual or longest value
  const char* when;   // in words
  uint8_t length;     // bytes
  bool fd;
  uint8_t repeats;  // the signals are a record that stands `repeats` times in the frame
  const Signal* signals;
  uint8_t signal_count;
  const char* comment;
};

constexpr int record_bits(const FrameDescription& frame) { return frame.length * 8 / frame.repeats; }

}  // namespace can
}  // namespace firmware
