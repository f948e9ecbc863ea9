#include "forces_of_rest.hpp"

#include <algorithm>
#include <cmath>

#include "choice/choice.hpp"

namespace diagnosis {
namespace {

constexpr double kForOneMore = 0.5;       // of what is missed with one force, at most, where two are named
constexpr double kFollowed_percent = 50;  // a run that misses less is in phase

// A rig with forces that it may lack, and what they are called there and in a cause.
struct Trial {
  rig_file::RigModel rig;
  std::vector<std::pair<const char*, const char*>> named;  // parameter, cause
};

bool has_spring(const rig_file::Coefficient& stiffness) { return stiffness.estimate || stiffness.value != 0; }

// offset_too: a constant force between masses moves nothing but their distance.
std::vector<Trial> trials_on(const rig_file::RigModel& rig, size_t link, bool offset_too) {
  const auto off = [&](Trial t) {
    t.rig.links[link].effects.push_back({"force_offset", {0.0, true}, {}});
    t.named.push_back({"force_offset", "force_offset"});
    return t;
  };
  std::vector<Trial> list;
  if (offset_too) list.push_back(off({rig, {}}));
  if (has_spring(rig.links[link].stiffness_N_m)) return list;
  Trial sprung{rig, {{"stiffness", "stiffness_error"}}};
  sprung.rig.links[link].stiffness_N_m.estimate = true;
  list.push_back(sprung);
  if (offset_too) list.push_back(off(sprung));
  return list;
}

// The spring was found from a fit of a rig that nothing pulls back: its own values are better first values.
bool lacks_a_spring(const Diagnosis& d, const rig_file::RigModel& rig) {
  return std::any_of(rig.links.begin(), rig.links.end(), [&](const rig_file::Link& link) {
    return !has_spring(link.stiffness_N_m) && d.names("stiffness_error", "link " + rig_file::link_label(link));
  });
}

// Of the extended rig; nullptr: it has none of that name.
Parameter* number_of(Diagnosis& d, const char* name, const rig_file::Link& link) {
  const std::string wanted = std::string(name) + "[" + rig_file::link_label(link) + "]";
  for (Parameter& p : d.extended.parameters)
    if (p.name == wanted) return &p;
  return nullptr;
}

// What followed with a spring of nought was a better start, or what else was found beside it.
bool all_beyond_nought(Diagnosis& d, const Trial& trial, const rig_file::Link& link) {
  return std::all_of(trial.named.begin(), trial.named.end(), [&](const auto& named) {
    const Parameter* const p = number_of(d, named.first, link);
    return p != nullptr && std::abs(p->value) > kHalfOf95 * p->std;
  });
}

// The judgement of a rig with such forces beside that of the rig as given: they are its causes.
Diagnosis with_forces_named(Diagnosis d, const Diagnosis& as_given, const Trial& trial, const rig_file::Link& link) {
  const std::string label = rig_file::link_label(link);
  const double before = as_given.baseline.most_missed_percent(), after = d.extended.most_missed_percent();
  for (auto named = trial.named.rbegin(); named != trial.named.rend(); ++named) {
    Cause cause;
    cause.effect = named->second, cause.where = "link " + label;
    if (Parameter* const p = number_of(d, named->first, link)) {
      if (p->std > 0) cause.significance = p->value / p->std * (p->value / p->std);
      p->name = cause.effect + "[" + label + "]";
      cause.parameters.push_back(*p);
    }
    cause.explains_percent = 100 * std::max(0.0, 1 - after / before);
    d.causes.insert(d.causes.begin(), cause);
  }
  if (d.verdict == Verdict::kNone) d.verdict = d.more_remains ? Verdict::kPartly : Verdict::kExplained;
  if (d.verdict == Verdict::kUnknown) d.verdict = Verdict::kPartly, d.more_remains = true;
  d.baseline = as_given.baseline, d.baseline_misfit = as_given.baseline_misfit;
  for (size_t i = 0; i < d.gain.size() && i < as_given.baseline.holdout_nrmse_percent.size(); ++i) {
    const double was = as_given.baseline.holdout_nrmse_percent[i], is = d.extended.holdout_nrmse_percent[i];
    d.gain[i] = is > 0 ? was / is : 1, d.remainder_percent[i] = was > 0 ? 100 * is / was : 100;
  }
  return d;
}

}  // namespace

bool describes(const Asked& asked) {
  const System system = make_system(asked.rig, asked.ground_known);
  const std::vector<runs::Prepared> records = runs::prepare_all(asked.rig, asked.training, asked.holdout);
  return !runs::rig_fitted({system, records, asked.training.size()}).base_fits_nothing;
}

bool follows_nothing(const Diagnosis& d) {
  const bool astray =
      d.verdict == Verdict::kUnknown && d.causes.empty() && d.extended.most_missed_percent() > kAllOfIt_percent;
  return astray || !d.cannot_describe.empty();
}

Diagnosis judged_where_it_rests(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  Diagnosis best = judge(asked);
  const bool followed_nothing = follows_nothing(best);
  if (!followed_nothing && !lacks_a_spring(best, asked.rig)) return best;
  const Diagnosis as_given = best;
  const Options silent{asked.options.top_of_band, nullptr};
  size_t named = 0;
  for (size_t l = 0; l < asked.rig.links.size(); ++l) {
    const bool to_ground = asked.rig.links[l].b <= 0;
    for (const Trial& trial : trials_on(asked.rig, l, followed_nothing && to_ground)) {
      const Asked with{trial.rig, asked.training, asked.holdout, silent, asked.ground_known};
      if (!describes(with)) continue;
      Diagnosis d = judge(with);
      const bool needs_more = named > 0 && trial.named.size() > named;
      const double missed = d.extended.most_missed_percent(),
                   least = (needs_more ? kForOneMore : 1) * best.extended.most_missed_percent();
      if (!d.cannot_describe.empty() || missed > kFollowed_percent || missed >= least) continue;
      if (!all_beyond_nought(d, trial, asked.rig.links[l])) continue;
      best = with_forces_named(d, as_given, trial, asked.rig.links[l]);
      named = trial.named.size();
    }
  }
  return best;
}

}  // namespace diagnosis
