#include "diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "search.hpp"

namespace diagnosis {
namespace {

std::string place_of(const System& s, const Term& t, const FusedRecord& f) {
  (void)f;
  if (t.link >= 0) {
    const rig_file::Link& l = s.links[static_cast<size_t>(t.link)];
    return "link " + std::to_string(l.a) + "-" + (l.b == rig_file::kBase ? "base" : std::to_string(l.b));
  }
  if (t.kind == Kind::kForceDelay || t.kind == Kind::kForceGain) return "channel force_" + std::to_string(t.dof + 1) + "_N";
  return "dof " + std::to_string(t.dof + 1);
}

}  // namespace

const char* verdict_word(Verdict v) {
  return v == Verdict::kNone ? "none" : v == Verdict::kExplained ? "explained" : v == Verdict::kAmbiguous ? "ambiguous" : "unknown";
}

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>&, const Options& options) {
  Diagnosis d;
  const System system = make_system(rig);
  std::vector<FusedRecord> records;
  for (const host_sim::Record& r : training) {
    records.push_back(read_record(rig, r, options.top_of_band));
    estimate_noise(records.back());
    fuse(records.back());
  }
  Rows rows(system, records);
  const CandidateBank bank(rows);
  const SearchResult found = search(rows, bank);
  d.baseline_misfit = found.base_fit.ratio();
  d.extended_misfit = found.fit.ratio();
  for (size_t i = 0; i < found.added.size(); ++i) {
    const Term& t = found.added[i].candidate.column.term;
    Cause c;
    c.effect = word_of(t.kind);
    c.where = place_of(system, t, records[0]);
    c.significance = found.added[i].score;
    c.parameters.push_back({c.effect, found.added[i].gain.coefficient, "", found.added[i].gain.std, true});
    if (t.shape > 0) c.parameters.push_back({"shape", t.shape, "", 0, true});
    d.causes.push_back(c);
    for (const Found& r : found.rivals[i])
      d.ambiguous_with.push_back({word_of(r.candidate.column.term.kind), place_of(system, r.candidate.column.term, records[0])});
  }
  const double drop = (found.base_fit.chi2 - found.fit.chi2) / found.fit.dof;
  const bool noise_only = found.fit.ratio() - 1 < 0.25 + 0.003 * drop;
  d.verdict = !noise_only ? Verdict::kUnknown
              : d.causes.empty() ? Verdict::kNone
              : d.ambiguous_with.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  return d;
}

}  // namespace diagnosis
