#include "firmware/conditioning/channel_shift.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

constexpr int kFractionBits = 30;
constexpr int kBefore = 2;  // of the six samples, before the interval that is read in
constexpr int32_t kLimit = 1 << 23;

}  // namespace

ShiftTaps shift_taps(const Scaled& late_samples, const Scaled& gain) {
  FIRMWARE_PRECONDITION(abs(late_samples) <= Scaled::from_int(kShiftReach - kBefore) && !gain.is_zero());
  ShiftTaps taps;
  const int64_t late = to_fixed(late_samples, kFractionBits);
  int whole = static_cast<int>(late >> kFractionBits);
  if (whole > kShiftReach - kBefore - 1) whole = kShiftReach - kBefore - 1;  // +3 itself: the end of the last interval
  const Scaled within = Scaled::from_int(late - (int64_t{whole} << kFractionBits), -kFractionBits);
  taps.first = whole - kBefore;
  for (int j = 0; j < kShiftTaps; ++j) {
    Scaled tap = kScaledOne / gain;
    for (int i = 0; i < kShiftTaps; ++i)
      if (i != j) tap = tap * (within + Scaled::from_int(kBefore - i)) / (j - i);
    taps.tap[j].raw = static_cast<int32_t>(to_fixed(tap, kFractionBits));
  }
  return taps;
}

#if FIRMWARE_WARRANT_NUMBERS > 0

void ChannelShift::set(int number, int channel, const ShiftTaps& taps) {
  FIRMWARE_PRECONDITION(number >= 0 && number < kMostShifted && number <= count_);
  if (number == count_) ++count_;
  shifted_[number] = {channel, taps};
}

int32_t ChannelShift::read(const Shifted& shifted, bool& at_limit) const {
  int from = back(kShiftReach - shifted.taps.first);
  int64_t sum = int64_t{1} << (kFractionBits - 1);
  for (const Fixed<int32_t, 30>& tap : shifted.taps.tap) {
    sum += int64_t{tap.raw} * history_[shifted.channel][from];
    if (++from == kShiftHistory) from = 0;
  }
  const int64_t code = sum >> kFractionBits;
  if (code <= kLimit && code >= -kLimit) return static_cast<int32_t>(code);
  at_limit = true;
  return code > 0 ? kLimit : -kLimit;
}

#endif

}  // namespace firmware
