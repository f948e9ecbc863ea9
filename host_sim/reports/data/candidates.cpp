#include "host_sim/reports/data/candidates.hpp"

#include <algorithm>

namespace host_sim::reports {
namespace {

bool is_named(const diagnosis::Diagnosis& found, const std::string& effect, const std::string& where) {
  return std::any_of(found.causes.begin(), found.causes.end(),
                     [&](const diagnosis::Cause& cause) { return cause.effect == effect && cause.where == where; });
}

std::string remark_on(const diagnosis::Diagnosis& found, const diagnosis::RankedCandidate& candidate) {
  const auto same = [&](const auto& other) {
    return other.effect == candidate.effect && other.where == candidate.where;
  };
  if (std::any_of(found.rejected.begin(), found.rejected.end(), same))
    return "fits better, but simulates the held-out data worse";
  if (std::any_of(found.ambiguous_with.begin(), found.ambiguous_with.end(), same)) return "fits equally well";
  if (candidate.score < candidate.threshold) return "not more than noise would bring";
  return found.causes.empty() ? "" : "nothing is left for it beside what is named";
}

}  // namespace

std::vector<Candidate> candidates(const diagnosis::Diagnosis& found) {
  std::vector<Candidate> out;
  const auto listed = [&](const diagnosis::Cause& cause) {
    return std::any_of(out.begin(), out.end(), [&](const Candidate& candidate) {
      return candidate.effect == cause.effect && candidate.where == cause.where;
    });
  };
  for (const diagnosis::Cause& cause : found.causes)
    if (cause.where.rfind("channel", 0) == 0)
      out.push_back({cause.effect, cause.where, cause.significance, 0.0, true, ""});
  for (const diagnosis::RankedCandidate& candidate : found.ranked)
    out.push_back({candidate.effect, candidate.where, candidate.score, candidate.threshold,
                   is_named(found, candidate.effect, candidate.where), remark_on(found, candidate)});
  for (const diagnosis::Cause& cause : found.causes)
    if (!listed(cause)) out.push_back({cause.effect, cause.where, cause.significance, 0.0, true, ""});
  for (const diagnosis::Cause& cause : found.rejected)
    if (!listed(cause))
      out.push_back({cause.effect, cause.where, cause.significance, 0.0, false,
                     "fits better, but simulates the held-out data worse"});
  return out;
}

}  // namespace host_sim::reports
