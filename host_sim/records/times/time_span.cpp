#include "host_sim/records/times/time_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/stretch.hpp"

namespace host_sim {
namespace {

// A step that is no whole number of binary places brings an instant that is meant to either side of the sample there.
constexpr double kOfStep = 1e-6;

struct Samples {
  size_t first = 0, end = 0;
};

Samples at_even_steps(const Record& record, const TimeSpan& span) {
  const double count = static_cast<double>(record.samples());
  const auto index = [&](double t_s) { return (t_s - record.start_s) / record.sample_period_s; };
  return {static_cast<size_t>(std::clamp(std::ceil(index(span.from_s) - kOfStep), 0.0, count)),
          static_cast<size_t>(std::clamp(std::floor(index(span.to_s) + kOfStep) + 1, 0.0, count))};
}

Samples at_own_times(const std::vector<double>& time_s, const TimeSpan& span) {
  const auto first = std::lower_bound(time_s.begin(), time_s.end(), span.from_s);
  const auto end = std::upper_bound(time_s.begin(), time_s.end(), span.to_s);
  return {static_cast<size_t>(first - time_s.begin()), static_cast<size_t>(end - time_s.begin())};
}

}  // namespace

Record within(Record record, const TimeSpan& span) {
  const bool own_times = !record.time_s.empty();
  const size_t count = record.samples();
  const auto instant_s = [&](size_t i) {
    return own_times ? record.time_s[i] : record.start_s + static_cast<double>(i) * record.sample_period_s;
  };
  const Samples part = own_times ? at_own_times(record.time_s, span) : at_even_steps(record, span);
  if (part.end < part.first + 2)
    throw DataFileError(
        record.file, 0,
        fmt::format("has {} samples from --from to --to, expected at least 2: it goes from {:.6g} to {:.6g} s",
                    part.end > part.first ? part.end - part.first : 0, instant_s(0), instant_s(count - 1)));
  record.notes.push_back(fmt::format("taken from {:.6g} to {:.6g} s: {} of {} samples", instant_s(part.first),
                                     instant_s(part.end - 1), part.end - part.first, count));
  return stretch_of(std::move(record), part.first, part.end);
}

}  // namespace host_sim
