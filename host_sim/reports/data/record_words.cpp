#include "host_sim/reports/data/record_words.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace host_sim::reports {
namespace {

std::string text(double value, const char* format) {
  char out[64];
  std::snprintf(out, sizeof out, format, value);
  return out;
}

}  // namespace

std::string lengths_text(const std::vector<Record>& records) {
  double sum_s = 0.0, shortest_s = 1e300, longest_s = 0.0;
  for (const Record& record : records) {
    const double length_s = static_cast<double>(record.samples()) * record.sample_period_s;
    sum_s += length_s, shortest_s = std::min(shortest_s, length_s), longest_s = std::max(longest_s, length_s);
  }
  if (records.size() == 1) return text(sum_s, "%.4g s");
  const std::string count = std::to_string(records.size()) + " records of ";
  if (longest_s < 1.005 * shortest_s) return count + text(longest_s, "%.4g s each");
  return count + text(sum_s, "%.4g s in all");
}

// Where the others agree to a twentieth it is plain which record is the odd one.
std::string odd_record_text(const diagnosis::Diagnosis& found) {
  constexpr double kAgree_percent = 5;
  if (!found.odd_record) return "";
  const diagnosis::OddRecord& odd = *found.odd_record;
  const std::string name = "ecord " + std::to_string(odd.record + 1) + " (" +
                           std::filesystem::path(odd.file).filename().string() + ")",
                    shares = text(odd.missed_percent, "%.0f %%"), others = text(odd.others_percent, "%.2g %%");
  const std::string disagree = odd.others_percent < kAgree_percent
                                   ? "R" + name + " does not go with the others: a free run misses " + shares +
                                         " of its motion and at most " + others + " of theirs."
                                   : "The records do not go with each other: a free run misses " + shares +
                                         " of the motion of r" + name + " and at most " + others + " of the others'.";
  return disagree +
         " Ask what has changed (another specimen, a stop that one alone reaches, a mounting), and diagnose each by "
         "itself.";
}

}  // namespace host_sim::reports
