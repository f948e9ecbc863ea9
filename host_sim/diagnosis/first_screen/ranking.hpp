// Every candidate beside the rig as given, best first: what the report lists.
#pragma once
#include <vector>

#include "../diagnosis.hpp"
#include "../search/search.hpp"

namespace diagnosis {

// The first `count`, one per effect and place, each with what it alone would bring.
std::vector<RankedCandidate> ranking(const System& system, const Rows& rows, const CandidateBank& bank,
                                     const SearchResult& found, size_t count);

}  // namespace diagnosis
