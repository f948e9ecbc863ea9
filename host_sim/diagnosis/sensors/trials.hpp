// Other readings of the same records, tried where the search says more than they might hold: a force that is held between
// its samples, a fault of a channel that no second one bears out.
#pragma once
#include <memory>

#include "../first_screen/bench.hpp"
#include "../search/search.hpp"

namespace diagnosis {

constexpr double kAsGood = 1.01;  // chi-squared of one reading over that of another that it equals

// A force that is said to be late or off in gain although one channel alone shows it may be held between its samples
// instead: it is, where that does as well with fewer terms. Bench and result are then those under the hold.
void try_holds(std::unique_ptr<Bench>& bench, SearchResult& found);

// The search, but where a fault of one channel that is alone on its DOF, and nothing else, makes noise of a residual far
// beyond it: then that is the answer, and the bench that of the corrected records.
SearchResult search_plain_first(std::unique_ptr<Bench>& bench, SensorCheck& check);

// Such faults, two at most, beside what was found: named where one does as well as more terms, better than as many, or shows
// beside those that were found. Bench, result and check then have it. Returns what explains a term of the result as well.
std::vector<NamedPlace> try_sole_channels(std::unique_ptr<Bench>& bench, SearchResult& found, SensorCheck& check);

// What is the same as a named fault of the force: with one mass its only channel's reading and that of the force differ by a
// factor that no equation knows.
std::vector<NamedPlace> equivalents(const Bench& bench, const SearchResult& found);

// The smallest fault of each such channel that would have been named beside a model.
std::vector<SensorFault> smallest_of_sole_channels(const Bench& bench, const SearchResult& found);

}  // namespace diagnosis
