#include "stretches.hpp"

#include <algorithm>

namespace diagnosis {
namespace {

// Samples times links and DOFs: some 450 bytes of rows and candidates each, so that they take 110 MB. 3 DOF and 4 links are read
// for 35 s at 1 kHz.
constexpr size_t kMostValues = 250000;
constexpr size_t kStretches = 4;    // of a record
constexpr size_t kShortest = 4096;  // samples: their ends, which the rows leave out, are a tenth of it

host_sim::Record part_of(const host_sim::Record& record, size_t first, size_t count) {
  host_sim::Record part;
  part.file = record.file;
  part.sample_period_s = record.sample_period_s, part.time_jitter_s = record.time_jitter_s;
  part.start_s = record.start_s + static_cast<double>(first) * record.sample_period_s;
  if (record.left_out_before) part.left_out_before = *record.left_out_before + first;
  for (const host_sim::Channel& c : record.channels) {
    const auto begin = c.values.begin() + static_cast<std::ptrdiff_t>(first);
    part.channels.push_back(
        {c.name, c.quantity, c.dof, {begin, begin + static_cast<std::ptrdiff_t>(count)}, c.recorded_step});
  }
  return part;
}

}  // namespace

std::vector<host_sim::Record> stretches(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records) {
  size_t samples = 0;
  for (const host_sim::Record& r : records) samples += r.samples();
  const size_t most = kMostValues / (rig.dofs.size() + rig.links.size());
  if (samples <= most) return records;
  std::vector<host_sim::Record> list;
  for (const host_sim::Record& r : records) {
    const size_t kept = r.samples() * most / samples, count = std::clamp<size_t>(kept / kShortest, 1, kStretches);
    const size_t length = std::min(r.samples(), std::max(kept / count, kShortest));
    for (size_t i = 0; i < count; ++i)
      list.push_back(part_of(r, (r.samples() - length) * (2 * i + 1) / (2 * count), length));
  }
  return list;
}

}  // namespace diagnosis
