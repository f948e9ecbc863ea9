// Rules that the frame table must keep, checked while compiling: no identifier twice, no bit in two signals, nothing
// outside its frame. Each function is true when the rule holds.
#pragma once
#include "firmware/can_protocol/frame_description.hpp"

namespace firmware {
namespace can {

struct IdSet {
  bool taken[0x800] = {};
};

// Takes every identifier of a frame; false where one is taken already or has more than 11 bits.
constexpr bool take_ids(const FrameDescription& frame, IdSet& set) {
  const bool per_node = frame.ids.node_stride > 0;
  for (int node = per_node ? kFirstNode : 0; node <= (per_node ? kLastNode : 0); ++node) {
    for (int member = 0; member < frame.ids.members; ++member) {
      const uint32_t id = frame_id(frame.ids, node, member);
      if (id >= 0x800 || set.taken[id]) return false;
      set.taken[id] = true;
    }
  }
  return true;
}

template <size_t N>
constexpr bool ids_do_not_collide(const FrameDescription* const (&frames)[N]) {
  IdSet set;
  for (size_t i = 0; i < N; ++i)
    if (!take_ids(*frames[i], set)) return false;
  return true;
}

// True where the signals of one record lie inside it and share no bit.
constexpr bool signals_fit(const FrameDescription& frame) {
  bool used[512] = {};
  for (int i = 0; i < frame.signal_count; ++i) {
    const Signal& signal = frame.signals[i];
    if (signal.length < 1 || signal.length > 32 || signal.start_bit + signal.length > record_bits(frame)) return false;
    for (int bit = signal.start_bit; bit < signal.start_bit + signal.length; ++bit) {
      if (used[bit]) return false;
      used[bit] = true;
    }
  }
  return frame.length <= (frame.fd ? 64 : 8) && record_bits(frame) * frame.repeats == frame.length * 8;
}

template <size_t N>
constexpr bool all_signals_fit(const FrameDescription* const (&frames)[N]) {
  for (size_t i = 0; i < N; ++i)
    if (!signals_fit(*frames[i])) return false;
  return true;
}

}  // namespace can
}  // namespace firmware
