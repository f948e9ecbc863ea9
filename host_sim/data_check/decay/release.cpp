#include "host_sim/data_check/decay/release.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/data_check/decay/free_decays.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/stretch.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kMostRecords = 8;  // of one call

// Nothing where the decays are the whole record.
std::optional<Finding> finding_of(const Record& record, const SortedDecays& sorted) {
  const std::vector<DecaySpan>& decays = sorted.kept;
  if (decays.empty() || (decays.size() == 1 && decays[0].from == 0 && decays[0].to == record.samples()))
    return std::nullopt;
  const auto at = [&](size_t sample) { return said_instant_s(record, static_cast<double>(sample)); };
  const auto listed = [&](const std::vector<DecaySpan>& spans) {
    std::string list;
    for (const DecaySpan& d : spans) list += (list.empty() ? "" : ", ") + at(d.from) + " to " + at(d.to) + " s";
    return list;
  };
  const bool clipped = std::any_of(decays.begin(), decays.end(), [](const DecaySpan& d) { return d.clipped; });
  return Finding{"release", Weight::kInforms, "",
                 "decays freely from " + listed(decays) + "; elsewhere " +
                     (clipped ? "a channel is at the end of its range, or " : "") +
                     "energy comes in that no force channel tells of (a hand, a pull, a blow; a hidden "
                     "mass that beats with it): left out by estimate and diagnose" +
                     (sorted.dropped.empty()
                          ? ""
                          : ", and so is " + listed(sorted.dropped) + ", which is at rest or too short to tell"),
                 record.start_s + static_cast<double>(decays[0].from) * record.sample_period_s};
}

}  // namespace

std::optional<Finding> find_release(const Record& record) { return finding_of(record, sorted_decays(record)); }

std::vector<std::string> keep_decays(std::vector<Record>& records) {
  std::vector<std::string> told;
  std::vector<Record> kept;
  size_t room = records.size() < kMostRecords ? kMostRecords - records.size() : 0;
  for (Record& record : records) {
    const SortedDecays sorted = sorted_decays(record);
    const auto finding = finding_of(record, sorted);
    if (!finding) {
      kept.push_back(std::move(record));
      continue;
    }
    told.push_back(record.file + ": " + finding->detail);
    size_t number = 0;
    for (const DecaySpan& d : sorted.kept) {
      if (number > 0 && room == 0) break;
      room -= number > 0 ? 1 : 0;
      kept.push_back(stretch_of(record, d.from, d.to));
      if (++number > 1) kept.back().file += fmt::format(", decay {}", number);
    }
  }
  records = std::move(kept);
  return told;
}

}  // namespace host_sim::data_check
