#include "host_sim/programs/estimate/rest_position.hpp"

#include <fmt/format.h>

#include <cmath>

namespace host_sim {
namespace {

constexpr double kOneSide = 2.0;  // rms about the mean: a sine whose mean is 1.4 of it just touches zero

struct Moments {
  double mean = 0, rms = 0;
};

Moments moments(const std::vector<Record>& records, size_t channel) {
  double sum = 0, squares = 0, count = 0;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) sum += value, count += 1;
  if (count == 0) return {};
  const double mean = sum / count;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / count)};
}

}  // namespace

std::vector<std::string> count_from_rest(SharedRecords& records) {
  std::vector<std::string> notes;
  if (records.get().empty()) return notes;
  for (size_t c = 0; c < records.get().front().channels.size(); ++c) {
    if (records.get().front().channels[c].quantity != Quantity::kDisplacement) continue;
    const Moments m = moments(records.get(), c);
    if (!(std::fabs(m.mean) > kOneSide * m.rms)) continue;
    for (Record& record : records.own())
      for (double& value : record.channels[c].values) value -= m.mean;
    notes.push_back(fmt::format("{} never comes to its zero: counted from its mean, {:.4g}, as the position of rest",
                                records.get().front().channels[c].name, m.mean));
  }
  return notes;
}

}  // namespace host_sim
