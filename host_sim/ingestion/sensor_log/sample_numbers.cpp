#include "host_sim/ingestion/sensor_log/sample_numbers.hpp"

#include <cmath>

namespace host_sim {
namespace {

constexpr double kRound = 65536.0;     // of a 16-bit sequence
constexpr double kPause = kRound / 4;  // samples: half of what it can tell, as the period is not exact
constexpr uint32_t kTellsPeriod = 16;  // samples: bus delays are a part of one

}  // namespace

double SampleNumbers::period_ns() const {
  if (numbers_.empty() || last_ns_ <= first_ns_) return 0.0;
  const uint32_t samples = numbers_.back() - numbers_.front();
  return samples < kTellsPeriod ? 0.0 : static_cast<double>(last_ns_ - first_ns_) / samples;
}

bool SampleNumbers::is_pause(uint64_t from_ns, uint64_t to_ns) const {
  const double period = period_ns();
  return period > 0.0 && to_ns > from_ns && static_cast<double>(to_ns - from_ns) > kPause * period;
}

uint32_t SampleNumbers::take(uint32_t sequence, uint64_t time_ns) {
  uint32_t number = sequence;
  if (numbers_.empty()) {
    first_ns_ = time_ns;
  } else {
    const auto told = static_cast<int16_t>(static_cast<uint16_t>(sequence - numbers_.back()));
    double ahead = told;
    const double period = period_ns();
    if (period > 0.0 && time_ns > last_ns_)
      ahead += kRound * std::nearbyint((static_cast<double>(time_ns - last_ns_) / period - ahead) / kRound);
    number = numbers_.back() + static_cast<uint32_t>(static_cast<int64_t>(ahead));
  }
  numbers_.push_back(number);
  last_ns_ = time_ns;
  return number;
}

}  // namespace host_sim
