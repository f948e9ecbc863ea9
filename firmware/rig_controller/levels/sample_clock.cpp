#include "firmware/rig_controller/levels/sample_clock.hpp"

namespace firmware {
namespace {

constexpr int64_t kWaiting_ns = 200000000;
constexpr int kShare = 20;

}  // namespace

bool SampleClock::off_rate(const Scaled& sample_period_s) const {
  if (first_ns_ == 0) return false;
  const Scaled counted_s = sample_period_s * Scaled::from_int(static_cast<int64_t>(last_ - first_));
  const Scaled taken_s = Scaled::from_int(static_cast<int64_t>(last_ns_ - first_ns_)) / 1000000000;
  const Scaled off_s = abs(taken_s - counted_s);
  return (off_s - Scaled::ratio(kWaiting_ns, 1000000000)) * kShare > counted_s;
}

}  // namespace firmware
