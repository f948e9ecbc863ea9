#include "later_start.hpp"

#include <algorithm>

#include "forces_of_rest.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/records/stretch.hpp"
#include "windows/windows.hpp"

namespace diagnosis {
namespace {

constexpr double kLaterStarts[] = {0.125, 0.25, 0.375, 0.5};  // of the motion: half of it has to be left
constexpr double kAllOfIt_percent = 100;                      // of a signal, missed by a free run

bool driven(const std::vector<host_sim::Record>& records) {
  return std::any_of(records.begin(), records.end(), [](const host_sim::Record& record) {
    return std::any_of(record.channels.begin(), record.channels.end(), host_sim::is_drive);
  });
}

std::vector<runs::Span> spans_of_motion(const Asked& asked) {
  std::vector<runs::Span> spans;
  for (const runs::Prepared& p : runs::prepare_all(asked.rig, asked.training, asked.holdout)) {
    runs::Span span = runs::moving_span(p, false);
    const double by = p.step_s / p.read_every_s;
    span.from = static_cast<Eigen::Index>(by * static_cast<double>(span.from));
    span.to = static_cast<Eigen::Index>(by * static_cast<double>(span.to));
    spans.push_back(span);
  }
  return spans;
}

// From that share of each record's motion on. spans: of each, in its own samples.
std::vector<host_sim::Record> begun_later(std::vector<host_sim::Record> records, const runs::Span* spans,
                                          double share) {
  for (host_sim::Record& record : records) {
    const double moves = static_cast<double>(spans->to - spans->from);
    const size_t first = static_cast<size_t>(static_cast<double>(spans->from) + share * moves), end = record.samples();
    if (first < end) record = host_sim::stretch_of(std::move(record), first, end);
    ++spans;
  }
  return records;
}

}  // namespace

Diagnosis judged_from_a_later_start(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis of_all = judge(asked);
  const bool astray = of_all.verdict == Verdict::kUnknown && of_all.causes.empty() &&
                      of_all.extended.most_missed_percent() > kAllOfIt_percent;
  if ((of_all.cannot_describe.empty() && !astray) || driven(asked.training) || driven(asked.holdout)) return of_all;
  const std::vector<runs::Span> spans = spans_of_motion(asked);
  const Options silent{asked.options.top_of_band, nullptr};
  Diagnosis best = of_all;
  for (double share : kLaterStarts) {
    const std::vector<host_sim::Record> training = begun_later(asked.training, spans.data(), share),
                                        holdout =
                                            begun_later(asked.holdout, spans.data() + asked.training.size(), share);
    const Asked later{asked.rig, training, holdout, silent, asked.ground_known};
    if (!describes(later)) continue;
    Diagnosis d = judge(later);
    if (!d.cannot_describe.empty()) continue;
    for (const host_sim::Record& record : training) d.told_from_s.push_back(record.start_s);
    if (d.verdict != Verdict::kUnknown) return d;
    if (!astray && !best.cannot_describe.empty()) best = d;
  }
  return best;
}

}  // namespace diagnosis
