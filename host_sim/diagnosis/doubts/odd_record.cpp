#include "odd_record.hpp"

#include <algorithm>

#include "../trial/settle.hpp"
#include "../unseen/score.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kFewestRecords = 3;  // of two nobody knows which is odd
constexpr double kOdd_percent = 5, kTimes = 3;

std::vector<double> missed_of_each(const Task& task, const State& state, const Vec& noise) {
  std::vector<double> missed;
  for (size_t r = 0; r < task.records.size(); ++r)
    missed.push_back(score_record(task, state, r, noise).beyond_noise_percent);
  return missed;
}

double most_but(const std::vector<double>& list, size_t r) {
  double most = 0;
  for (size_t i = 0; i < list.size(); ++i)
    if (i != r) most = std::max(most, list[i]);
  return most;
}

// The same model fitted to the other records. Not ok where they have no windows.
State fitted_without(const Task& task, const State& state, size_t record) {
  State other = state;
  const auto own = [record](const Window& w) { return w.record == record; };
  other.seen.erase(std::remove_if(other.seen.begin(), other.seen.end(), own), other.seen.end());
  if (other.seen.empty())
    other.fit.ok = false;
  else if (other.seen.size() < state.seen.size())
    settle(task, other, kBaseSteps);
  return other;
}

// What is missed of it with numbers of its own: much of it then is its start, which no numbers mend.
double missed_by_itself(const Task& task, const State& state, size_t record, const Vec& noise) {
  State own = state;
  own.seen.clear(), own.unseen.clear();
  for (const std::vector<Window>* windows : {&state.seen, &state.unseen})
    for (const Window& w : *windows)
      if (w.record == record) own.seen.push_back(w);
  if (own.seen.empty()) return 0;
  settle(task, own, kBaseSteps);
  return own.fit.ok ? score_record(task, own, record, noise).beyond_noise_percent : 0;
}

}  // namespace

std::optional<OddRecord> odd_record(const Task& task, const Choice& choice) {
  if (task.records.size() < kFewestRecords || !choice.final.fit.ok || massless(choice.final.model)) return std::nullopt;
  const Vec& noise = choice.final_left.sensor_noise;
  const std::vector<double> all = missed_of_each(task, choice.final, noise);
  if (*std::max_element(all.begin(), all.end()) < kOdd_percent) return std::nullopt;
  std::optional<OddRecord> odd;
  for (size_t r = 0; r < all.size(); ++r) {
    const State without = fitted_without(task, choice.final, r);
    if (!without.fit.ok) continue;
    const std::vector<double> missed = missed_of_each(task, without, noise);
    const double others = most_but(missed, r);
    if (missed[r] < kOdd_percent || missed[r] < kTimes * others || others > 100 * kFollows) continue;
    if (!odd || others < odd->others_percent) odd = OddRecord{r, task.records[r].file, missed[r], others};
  }
  const bool far_off = odd && odd->missed_percent > 100 * kFollows;  // another law in it is no matter of numbers
  if (odd && !far_off && 2 * missed_by_itself(task, choice.final, odd->record, noise) > odd->missed_percent)
    return std::nullopt;
  return odd;
}

void say_odd_record(const Task& task, const Choice& choice, Diagnosis& d) {
  if (d.verdict == Verdict::kAmbiguous || !d.cannot_describe.empty()) return;
  d.odd_record = odd_record(task, choice);
  if (!d.odd_record) return;
  if (d.verdict == Verdict::kNone) d.verdict = Verdict::kUnknown;
  if (d.verdict == Verdict::kExplained) d.verdict = Verdict::kPartly;
  d.more_remains = true;
  for (ModelScore* score : {&d.baseline, &d.extended})
    for (diagnosis::Parameter& p : score->parameters) p.may_be_bent = true;
}

}  // namespace diagnosis::runs
