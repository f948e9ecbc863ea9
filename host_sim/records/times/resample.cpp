#include "host_sim/records/times/resample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/parts_kept.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/records/steps/tick_log.hpp"
#include "host_sim/records/steps/updates.hpp"
#include "host_sim/records/steps/value_step.hpp"
#include "host_sim/records/times/even_times.hpp"
#include "host_sim/records/times/times_by_motion.hpp"

namespace host_sim {
namespace {

constexpr size_t kPoints = 6;
// Sum of the sizes of a polynomial's weights: what it makes of noise at the worst. Of six even rows it is 1.4 in their middle and 3.1
// between the first two; of rows a third of a step early or late it stays below 2.6 there, and in 99 of 100 below 7.
constexpr double kMostGain = 3.0, kMostGainAtEnds = 8.0;
constexpr double kMostSamples = 1e8;  // of a channel: 0.8 GB
constexpr double kSameRate = 0.9;     // a rate this far below the record's own is meant as a lower one

std::vector<double> times_of(const Record& record) {
  if (!record.time_s.empty()) return record.time_s;
  std::vector<double> time_s(record.samples());
  for (size_t i = 0; i < time_s.size(); ++i)
    time_s[i] = record.start_s + static_cast<double>(i) * record.sample_period_s;
  return time_s;
}

// Samples `first` to `end`, without a gap.
struct Part {
  size_t first = 0, end = 0;
};

std::vector<Part> parts_of(const std::vector<double>& time_s, double step) {
  std::vector<Part> parts;
  for (size_t first = 0, i = 1; i <= time_s.size(); ++i) {
    if (i < time_s.size() && time_s[i] - time_s[i - 1] <= kLongestGap * step) continue;
    if (i - first >= kFewestSamples) parts.push_back({first, i});
    first = i;
  }
  return parts;
}

// Between gaps, times that are even but for their last decimal are made so: motion times half a decimal would be noise. Not where the
// motion shows that they are right as they are.
void make_even(const Record& record, std::vector<double>& time_s, const Part& part) {
  const auto first = time_s.begin() + static_cast<std::ptrdiff_t>(part.first);
  const std::vector<double> given(first, time_s.begin() + static_cast<std::ptrdiff_t>(part.end));
  const EvenTimes even = even_times(given);
  if (even.time_s.empty() || smoother_as_given(record, part.first, given, even.time_s)) return;
  std::copy(even.time_s.begin(), even.time_s.end(), first);
}

// The polynomial leaves a flat top at its edges, and the top would be flat no more. So where a channel stays at its highest or
// lowest value for three samples in a row (a smooth motion turns within two), what it reads ends there.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
};
Range range_of(const std::vector<double>& values) {
  constexpr size_t kFlat = 3;
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const auto stays_at = [&](double end) {
    return std::search_n(values.begin(), values.end(), kFlat, end) != values.end();
  };
  Range range;
  if (stays_at(*lowest)) range.lowest = *lowest;
  if (stays_at(*highest)) range.highest = *highest;
  return range;
}

// The points around an instant whose polynomial is taken there, and their weights.
struct Points {
  size_t first = 0, count = 0;
};
// Six, but fewer where rows lie so unevenly (two of them nearly at one time) that the polynomial would make of their noise many times
// as much between them: it has to turn from one row to the next within the little that is between the two. Two never leave their range.
Points weights_around(const std::vector<double>& time_s, const Part& part, size_t before, double t, double* weight) {
  for (size_t count = kPoints;; count -= 2) {
    const size_t half = count / 2 - 1;
    const size_t first = std::min(before < part.first + half ? part.first : before - half, part.end - count);
    weights_at(&time_s[first], count, t, weight);
    double gain = 0.0;
    for (size_t j = 0; j < count; ++j) gain += std::abs(weight[j]);
    if (count == 2 || gain <= (first + half == before ? kMostGain : kMostGainAtEnds)) return {first, count};
  }
}

Record part_at(const Record& record, const std::vector<double>& time_s, const Part& part, double rate_Hz) {
  Record out;
  out.file = record.file;
  out.start_s = time_s[part.first];
  out.sample_period_s = 1.0 / rate_Hz;
  out.left_out_before.reset();
  const size_t count = samples_at(record.file, time_s[part.end - 1] - out.start_s, rate_Hz);
  std::vector<Range> ranges;
  for (const Channel& channel : record.channels) {
    out.channels.push_back(
        {channel.name, channel.quantity, channel.dof, std::vector<double>(count), 0.0, channel.held});
    ranges.push_back(range_of(channel.values));
  }
  size_t before = part.first;  // the last sample that is not after t
  double weight[kPoints];
  for (size_t i = 0; i < count; ++i) {
    const double t = out.start_s + static_cast<double>(i) / rate_Hz;
    while (before + 1 < part.end && time_s[before + 1] <= t) ++before;
    const auto [first, points] = weights_around(time_s, part, before, t, weight);
    for (size_t c = 0; c < out.channels.size(); ++c) {
      if (out.channels[c].held) {
        out.channels[c].values[i] = record.channels[c].values[before];
        continue;
      }
      // from one of the points on: six alike give that value to the last bit, and a channel that rests goes on resting
      const double* values = &record.channels[c].values[first];
      double value = values[points / 2];
      for (size_t j = 0; j < points; ++j) value += weight[j] * (values[j] - values[points / 2]);
      out.channels[c].values[i] = std::clamp(value, ranges[c].lowest, ranges[c].highest);
    }
  }
  return out;
}

}  // namespace

size_t samples_at(const std::string& file, double length_s, double rate_Hz) {
  const double length = length_s * rate_Hz * (1.0 + 1e-12);
  if (length > kMostSamples)
    throw DataFileError(
        file, 0,
        fmt::format("makes {:.3g} samples at {:.4g} a second, expected a rate that makes {:.3g} at the most", length,
                    rate_Hz, kMostSamples));
  return static_cast<size_t>(length) + 1;
}

std::vector<Record> resampled(const Record& record, double rate_Hz) {
  std::vector<double> time_s = times_of(record);
  if (time_s.size() < kFewestSamples)
    throw DataFileError(record.file, 0,
                        fmt::format("holds {} samples, expected at least {}", time_s.size(), kFewestSamples));
  if (const double ticks = tick_step(record); ticks > 0.0) return {resampled_ticks(record, ticks, rate_Hz)};
  const double step = record.own_step_s > 0.0 ? record.own_step_s : median_step(time_s);
  if (rate_Hz < kSameRate / step)
    throw DataFileError(
        record.file, 0,
        fmt::format("has {:.4g} samples a second; at {:.4g} what lies between would fold into the band, "
                    "expected a filter and fewer samples in the file, or --resample {:.4g}",
                    1.0 / step, rate_Hz, 1.0 / step));
  std::vector<Record> records;
  for (const Part& part : parts_of(time_s, step)) {
    make_even(record, time_s, part);
    records.push_back(part_at(record, time_s, part, rate_Hz));
    records.back().own_step_s = step;
  }
  for (size_t c = 0; c < record.channels.size(); ++c) {
    if (counts_marks(time_s, record.channels[c].values)) continue;
    const double step_of_values = value_step(record.channels[c]);
    const double rows = rows_per_update(record.channels[c].values, step_of_values);
    for (Record& part : records) {
      part.channels[c].recorded_step = step_of_values;
      part.channels[c].update_s = rows > 1.0 ? rows * step : 0.0;
    }
  }
  if (records.empty())
    throw DataFileError(record.file, 0, fmt::format("has no {} samples without a gap", kFewestSamples));
  const size_t parts = records.size();
  for (size_t i = 1; i < parts; ++i) records[i].file += fmt::format(", part {}", i + 1);
  const std::string left_out = leave_out_parts(records);
  size_t kept = 0;
  for (const Record& part : records) kept += part.samples();
  records.front().notes = record.notes;
  records.front().notes.push_back(fmt::format("interpolated onto {:.6g} samples a second", rate_Hz) +
                                  (parts > 1 ? fmt::format(", in {} parts between gaps", parts) : "") +
                                  (left_out.empty() ? "" : ", " + left_out) +
                                  fmt::format(": {} samples of {}", kept, time_s.size()));
  return records;
}

}  // namespace host_sim
