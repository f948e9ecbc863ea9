// A channel read at another time and with another gain than its codes say: what the warrant has found wrong with it is taken out.
//
// All channels wait kShiftReach samples; a shifted one is interpolated among its neighbours, by the polynomial of degree 5 through
// the six nearest (Lagrange), and divided by its gain. With ten samples a period it is right to 3e-4, at five to 2 %.
//
// Formats: code 24 bits; taps Q30, of either sign: their magnitudes add up to at most 1.39 of one, divided by a gain of 0.8 to 1.74.
// Six products stay below 2^53.8 in int64; the sum is rounded to nearest and saturated to 24 bits.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"

namespace firmware {

// A core that can test what it has corrected.
constexpr bool kCorrectsChannels = kWarrantNumbers > 0;
constexpr int kMostShifted = 4;  // channels; what a sample may cost is bounded

constexpr int kShiftTaps = 6, kShiftReach = 5, kShiftHistory = 2 * kShiftReach + 1;

struct ShiftTaps {
  int first = 0;  // samples from the one that is read to the first of the six; tap[0] weighs that one
  Fixed<int32_t, 30> tap[kShiftTaps];
};

// What reads a channel late_samples later (-3 to below 3: a late channel's future) and divides it by gain (0.8 to 1.25).
ShiftTaps shift_taps(const Scaled& late_samples, const Scaled& gain);

#if FIRMWARE_WARRANT_NUMBERS > 0

// Codes of all channels, the newest kShiftHistory samples of each.
class ChannelShift {
 public:
  void clear() { count_ = 0; }  // nothing is shifted any more
  // number: 0 to kMostShifted - 1, in order. channel: as the caller counts them.
  void set(int number, int channel, const ShiftTaps& taps);
  void restart() { held_ = at_ = 0; }
  bool used() const { return count_ > 0; }
  // code(c): the newest code of channel c, in place replaced by what it is kShiftReach samples ago. False while the
  // histories fill: the codes are not to be used. at_limit: a shifted one left its 24 bits.
  template <typename CodeOf>
  bool shift(int channels, CodeOf code, bool& at_limit);

 private:
  struct Shifted {
    int channel = 0;
    ShiftTaps taps;
  };
  int back(int samples) const { return at_ >= samples ? at_ - samples : at_ - samples + kShiftHistory; }
  int32_t read(const Shifted& shifted, bool& at_limit) const;

  int count_ = 0, held_ = 0, at_ = 0;
  Shifted shifted_[kMostShifted];
  int32_t history_[kMaxNodes * kQuantities][kShiftHistory] = {};
};

template <typename CodeOf>
bool ChannelShift::shift(int channels, CodeOf code, bool& at_limit) {
  for (int c = 0; c < channels; ++c) history_[c][at_] = code(c);
  const bool full = held_ == kShiftHistory - 1;
  if (full) {
    const int waited = back(kShiftReach);
    for (int c = 0; c < channels; ++c) code(c) = history_[c][waited];
    for (int s = 0; s < count_; ++s) code(shifted_[s].channel) = read(shifted_[s], at_limit);
  } else {
    ++held_;
  }
  if (++at_ == kShiftHistory) at_ = 0;
  return full;
}

#else

class ChannelShift {
 public:
  void clear() {}
  void set(int, int, const ShiftTaps&) {}
  void restart() {}
  bool used() const { return false; }
  template <typename CodeOf>
  bool shift(int, CodeOf, bool&) {
    return true;
  }
};

#endif

}  // namespace firmware
