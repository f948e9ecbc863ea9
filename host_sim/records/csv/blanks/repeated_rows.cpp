#include "host_sim/records/csv/blanks/repeated_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace host_sim {
namespace {

// Of rows that bear the time of the one before, whether all are it word by word, many of them, and no others: then they stand twice.
// A clock in coarse ticks has such rows too while the sensors rest.
bool stand_twice(const CsvTable& table, const std::vector<bool>& keep) {
  constexpr double kMany = 0.05, kResting = 0.1;  // of the rows
  const std::vector<Channel>& channels = table.record.channels;
  size_t of_one_time = 0, resting = 0;
  for (size_t i = 1; i < table.samples; ++i) {
    of_one_time += table.time_s[i] == table.time_s[i - 1] ? 1 : 0;
    resting += keep[i] && std::all_of(channels.begin(), channels.end(), [i](const Channel& channel) {
                 return channel.values[i] == channel.values[i - 1];
               });
  }
  const auto rows = static_cast<double>(table.samples), many = static_cast<double>(table.repeats.size());
  return of_one_time == table.repeats.size() && of_one_time + 1 < table.samples && many > kMany * rows &&
         static_cast<double>(resting) < kResting * (rows - many);
}

}  // namespace

void leave_out_repeats(CsvTable& table) {
  if (table.repeats.empty() || table.rate_Hz > 0.0) return;
  std::vector<bool> keep(table.samples, true);
  for (const size_t sample : table.repeats) keep[sample] = false;
  if (!stand_twice(table, keep)) return;
  table.record.notes.push_back(fmt::format("left out: {} rows that stand twice", table.repeats.size()));
  table.keep_samples(keep);
}

}  // namespace host_sim
