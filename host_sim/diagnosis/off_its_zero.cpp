#include "off_its_zero.hpp"

#include <algorithm>

#include "choice/choice.hpp"

namespace diagnosis {
namespace {

constexpr double kAllOfIt_percent = 100;  // of a signal, missed by a free run: not even its mean is right
constexpr double kFollowed_percent = 50;  // a run that misses less is in phase

// The judgement of a rig with a constant force beside that of the rig as given: the force is its cause.
Diagnosis with_offset_named(Diagnosis d, const Diagnosis& as_given, const rig_file::Link& link) {
  const std::string label = rig_file::link_label(link);
  Cause offset;
  offset.effect = "force_offset", offset.where = "link " + label;
  const std::string name = offset.effect + "[" + label + "]";
  for (const Parameter& p : d.extended.parameters)
    if (p.name == name) offset.parameters.push_back(p);
  const double before = as_given.extended.most_missed_percent(), after = d.extended.most_missed_percent();
  offset.explains_percent = 100 * std::max(0.0, 1 - after / before);
  d.causes.insert(d.causes.begin(), offset);
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

Diagnosis judged_off_its_zero(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  Diagnosis best = judge(asked);
  const bool astray = best.verdict == Verdict::kUnknown && best.causes.empty() &&
                      best.extended.most_missed_percent() > kAllOfIt_percent;
  if (!astray && best.cannot_describe.empty()) return best;
  const Diagnosis as_given = best;
  const Options silent{asked.options.top_of_band, nullptr};
  for (size_t l = 0; l < asked.rig.links.size(); ++l) {
    if (asked.rig.links[l].b > 0) continue;
    rig_file::RigModel rig = asked.rig;
    rig.links[l].effects.push_back({"force_offset", {0.0, true}, {}});
    const Asked off{rig, asked.training, asked.holdout, silent, asked.ground_known};
    if (!describes(off)) continue;
    const Diagnosis d = judge(off);
    if (d.cannot_describe.empty() && d.extended.most_missed_percent() < kFollowed_percent &&
        d.extended.most_missed_percent() < best.extended.most_missed_percent())
      best = with_offset_named(d, as_given, rig.links[l]);
  }
  return best;
}

}  // namespace diagnosis
