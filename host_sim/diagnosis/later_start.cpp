#include "later_start.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/error_rates.hpp"
#include "forces_of_rest.hpp"
#include "host_sim/records/stretch.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"
#include "numbers/numbers_of.hpp"
#include "windows/windows.hpp"

namespace diagnosis {
namespace {

constexpr double kLaterStarts[] = {0.125, 0.25, 0.375, 0.5};  // of the motion: half of it has to be left

constexpr double kAsMuch = 0.8;    // of what all of it leaves unseen
constexpr double kNothing = 0.01;  // of a number: a swing or two of noise that is not white move it as much

// Of each record, in its own samples.
std::vector<runs::Span> spans_of_motion(const std::vector<runs::Prepared>& records) {
  std::vector<runs::Span> spans;
  for (const runs::Prepared& p : records) {
    runs::Span span = runs::moving_span(p, false);
    const double by = p.step_s / p.read_every_s;
    span.from = static_cast<Eigen::Index>(by * static_cast<double>(span.from));
    span.to = static_cast<Eigen::Index>(by * static_cast<double>(span.to));
    spans.push_back(span);
  }
  return spans;
}

// From that share of each record's motion on.
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

// What is asked about, from that share of each record's motion on; spans: of the fitted records, then of the unseen ones.
struct Later {
  std::vector<host_sim::Record> training, holdout;
  Later(const Asked& asked, const std::vector<runs::Span>& spans, double share)
      : training(begun_later(asked.training, spans.data(), share)),
        holdout(begun_later(asked.holdout, spans.data() + asked.training.size(), share)) {}
};

// Of a record whose start is cut off already, because a hand acts there, more of the start may be the hand's.
bool begins_cut(const std::vector<host_sim::Record>& records) {
  return std::any_of(records.begin(), records.end(),
                     [](const host_sim::Record& record) { return record.left_out_before.value_or(0) > 0; });
}

// Of `asked`, whose records `prepared` are.
std::vector<Parameter> numbers_fitted(const Asked& asked, const std::vector<runs::Prepared>& prepared) {
  const System system = make_system(asked.rig, asked.ground_known);
  const runs::Task task{system, prepared, asked.training.size()};
  const runs::State base = runs::rig_fitted(task).base;
  return base.fit.ok ? runs::numbers_of(task, base) : std::vector<Parameter>{};
}

// Beyond chance, which has as many tries as there are numbers, and by more than nothing.
bool moves(const Parameter& of_all, const Parameter& of_half) {
  const double by = std::abs(of_half.value - of_all.value);
  return by > runs::kSure * std::max(of_all.std, of_half.std) && by > kNothing * std::abs(of_all.value);
}

// Whether what was said of the motion from an instant on is said of its later half too: a hand is gone then, a law that larger motion
// shows goes on to move the numbers, and the less of it is left the better noise hides it.
bool holds_on(const Asked& later, const Diagnosis& d) try {
  const rig_file::RigModel& rig = d.causes.empty() ? later.rig : d.extended_rig;
  const Asked whole{rig, later.training, later.holdout, later.options, later.ground_known};
  const std::vector<runs::Prepared> records = runs::prepare_all(rig, later.training, later.holdout);
  const Later half_of(later, spans_of_motion(records), 0.5);
  const Asked rest{rig, half_of.training, half_of.holdout, later.options, later.ground_known};
  const std::vector<Parameter> all = numbers_fitted(whole, records),
                               half = numbers_fitted(rest, runs::prepare_all(rig, rest.training, rest.holdout));
  if (half.size() != all.size()) return false;
  for (size_t i = 0; i < all.size(); ++i)
    if (moves(all[i], half[i])) return false;
  return true;
} catch (const CannotAnswer&) {
  return false;
}

bool leaves_something(const Diagnosis& d) { return d.verdict == Verdict::kUnknown || d.more_remains; }

// What is left does not come from the start, and is not sought any later.
bool misses_as_much(const Diagnosis& later, const Diagnosis& of_all) {
  return later.extended.most_missed_percent() > kAsMuch * of_all.extended.most_missed_percent();
}

// Nothing where the rig file describes nothing of it either, too little is left to tell, or what is unseen is missed by all it is: what
// slows down all the time looks simple in its last part.
std::optional<Diagnosis> told(const Asked& asked, Diagnosis (*judge)(const Asked&)) try {
  if (!describes(asked)) return {};
  const Diagnosis d = judge(asked);
  if (!d.cannot_describe.empty() || d.extended.most_missed_percent() > kAllOfIt_percent) return {};
  return d;
} catch (const CannotAnswer&) {
  return {};
}

}  // namespace

Diagnosis judged_from_a_later_start(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis of_all = judge(asked);
  if (!vocabulary::held_in_place(asked.rig)) return of_all;  // what coasts has no start: all of it is one slowing down
  const bool nothing = follows_nothing(of_all);
  const bool unknown = of_all.verdict == Verdict::kUnknown;
  if (!nothing && !unknown && !(of_all.more_remains && begins_cut(asked.training))) return of_all;
  const std::vector<runs::Prepared> records = runs::prepare_all(asked.rig, asked.training, asked.holdout);
  if (runs::forced(records)) return of_all;
  const std::vector<runs::Span> spans = spans_of_motion(records);
  const Options silent{asked.options.top_of_band, nullptr};
  Diagnosis best = of_all;
  for (double share : kLaterStarts) {
    const Later begun(asked, spans, share);
    const Asked later{asked.rig, begun.training, begun.holdout, silent, asked.ground_known};
    std::optional<Diagnosis> d = told(later, judge);
    if (!d) continue;
    for (const host_sim::Record& record : begun.training) d->told_from_s.push_back(record.start_s);
    if (nothing || unknown ? d->verdict != Verdict::kUnknown : !leaves_something(*d))
      return holds_on(later, *d) ? *d : of_all;
    if (!nothing && misses_as_much(*d, of_all)) return of_all;
    if (!best.cannot_describe.empty()) best = *d;
  }
  return best;
}

}  // namespace diagnosis
