#include "host_sim/live/state/bus_link.hpp"

#include <algorithm>

#include "firmware/can_protocol/load/bus_load.hpp"
#include "host_sim/can_log/readable.hpp"

namespace live {
namespace {

constexpr uint32_t kErrorBusOff = 0x040, kErrorRestarted = 0x100;  // linux/can/error.h
constexpr int kExtendedBits = 20, kExtendedStuffBits = 5;          // 18 bits of identifier, and two more

std::string seconds_text(uint64_t duration_ns) {
  const double seconds = static_cast<double>(duration_ns) / 1e9;
  char text[32];
  std::snprintf(text, sizeof text, seconds < 100 ? "%.1f s" : "%.0f s", seconds);
  return text;
}

}  // namespace

int64_t longest_duration_ns(const hal::CanFrame& frame, const BitRates& rates) {
  constexpr int64_t kSecond_ns = 1000000000;
  const int extended = frame.extended ? kExtendedBits + kExtendedStuffBits : 0;
  if (!frame.fd)
    return kSecond_ns * (firmware::can::classic_bits(frame.remote ? 0 : frame.length) + extended) / rates.nominal_bit_s;
  const firmware::can::FdBits bits = firmware::can::fd_bits(frame.length);
  const bool fast = (frame.flags & 1) != 0;
  return kSecond_ns * (bits.nominal + extended) / rates.nominal_bit_s +
         kSecond_ns * bits.data / (fast ? rates.data_bit_s : rates.nominal_bit_s);
}

std::string BusLink::leave(BusPhase phase, uint64_t since_ns, const std::string& words) {
  if (phase_ == phase) return "";
  const bool was_here = phase_ == BusPhase::kUp || phase_ == BusPhase::kWaiting;
  phase_ = phase;
  if (was_here) {
    since_ns_ = since_ns;
    ++absences_;
  }
  return words;
}

std::string BusLink::come_back(uint64_t now_ns) {
  if (phase_ == BusPhase::kUp) return "";
  const bool was_away = phase_ != BusPhase::kWaiting;
  const uint64_t away_ns = now_ns > since_ns_ ? now_ns - since_ns_ : 0;
  phase_ = BusPhase::kUp;
  since_ns_ = now_ns;
  return was_away ? "bus back after " + seconds_text(away_ns) : "";
}

std::string BusLink::take(const can_log::LogEntry& entry) {
  const uint64_t time_ns = entry.frame.time_ns;
  now_ns_ = std::max(now_ns_, time_ns);
  if (time_ns + kLoadSpan_ns < last_frame_ns_) {  // another log has begun
    passed_.clear();
    now_ns_ = first_frame_ns_ = time_ns;
  }
  if (frames_ + error_frames_ == 0) first_frame_ns_ = time_ns;
  last_frame_ns_ = time_ns;
  if (entry.frame.error) {
    ++error_frames_;
    if ((entry.frame.id & kErrorBusOff) != 0) return leave(BusPhase::kOff, time_ns, "bus-off");
    if ((entry.frame.id & kErrorRestarted) != 0) return come_back(time_ns);
    return can_log::error_frame_text(entry.frame);
  }
  ++frames_;
  passed_.push_back({time_ns, longest_duration_ns(entry.frame, rates_)});
  forget_before(now_ns_);
  return come_back(time_ns);
}

std::string BusLink::advance(uint64_t now_ns) {
  now_ns_ = std::max(now_ns_, now_ns);
  forget_before(now_ns_);
  const bool silent = phase_ == BusPhase::kUp && now_ns_ > last_frame_ns_ + kSilence_ns;
  return silent ? leave(BusPhase::kSilent, last_frame_ns_, "bus silent") : "";
}

std::string BusLink::went_down(uint64_t now_ns) {
  now_ns_ = std::max(now_ns_, now_ns);
  return leave(BusPhase::kDown, now_ns, "interface down");
}

void BusLink::forget_before(uint64_t now_ns) {
  while (!passed_.empty() && passed_.front().time_ns + kLoadSpan_ns <= now_ns) passed_.pop_front();
}

// In the first second the span is shorter; a tenth of a second is the least that says anything.
double BusLink::frames_per_s() const {
  const uint64_t since_start_ns = now_ns_ - std::min(first_frame_ns_, now_ns_);
  const uint64_t span_ns = std::clamp<uint64_t>(since_start_ns, kLoadSpan_ns / 10, kLoadSpan_ns);
  return static_cast<double>(passed_.size()) * 1e9 / static_cast<double>(span_ns);
}

double BusLink::load_percent() const {
  int64_t busy_ns = 0;
  for (const Passed& frame : passed_) busy_ns += frame.duration_ns;
  return passed_.empty() ? 0.0
                         : 100e-9 * static_cast<double>(busy_ns) * frames_per_s() / static_cast<double>(passed_.size());
}

}  // namespace live
