#include "released.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/record_checks.hpp"
#include "host_sim/records/stretch.hpp"

namespace diagnosis {
namespace {

// Of a record: its start. At the end of a decay nothing is as large as at its start: what follows is compared over as much again.
constexpr double kStart = 0.02;
constexpr size_t kLeast = 50;  // samples of that
constexpr double kTimes = 2;   // the steps behind it; what is taken for one and is none costs the start alone

// Samples before the jump of one channel; 0: there is none.
size_t held_samples(const std::vector<double>& y) {
  const size_t start = std::max(kLeast, static_cast<size_t>(kStart * static_cast<double>(y.size())));
  if (y.size() < 4 * start) return 0;
  const auto step = [&](size_t k) { return std::abs(y[k + 1] - y[k]); };
  size_t largest = 0;
  for (size_t k = 1; k < start; ++k)
    if (step(k) > step(largest)) largest = k;
  double behind = 0;
  for (size_t k = largest + 1; k < largest + 2 * start; ++k) behind = std::max(behind, step(k));
  return step(largest) > kTimes * behind ? largest + 1 : 0;
}

size_t held_samples(const host_sim::Record& record) {
  size_t held = 0;
  if (host_sim::has_drive(record)) return held;
  for (const host_sim::Channel& c : record.channels)
    if (c.quantity == host_sim::Quantity::kAcceleration) held = std::max(held, held_samples(c.values));
  return held;
}

}  // namespace

bool any_begins_held(const std::vector<host_sim::Record>& records) {
  return std::any_of(records.begin(), records.end(),
                     [](const host_sim::Record& record) { return held_samples(record) > 0; });
}

std::vector<host_sim::Record> from_release(std::vector<host_sim::Record> records) {
  for (host_sim::Record& record : records)
    if (const size_t held = held_samples(record); held > 0) {
      const size_t end = record.samples();
      record = host_sim::stretch_of(std::move(record), held, end);
    }
  return records;
}

}  // namespace diagnosis
