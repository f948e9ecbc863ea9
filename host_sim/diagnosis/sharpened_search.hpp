// The search, repeated with what it found out about the motion and the force.
#pragma once
#include <memory>

#include "bench.hpp"
#include "search.hpp"

namespace diagnosis {

// Again with the motion that the found terms sharpen: they move the reversals of friction and, in steps, the slow motion
// where that is not measured. The bench is then that of the last search.
SearchResult search_sharpening(std::unique_ptr<Bench>& bench);

// A force that is said to be late or off in gain although one channel alone shows it may be held between its samples
// instead: it is, where that does as well with fewer terms. Bench and result are then those under the hold.
void try_holds(std::unique_ptr<Bench>& bench, SearchResult& found);

}  // namespace diagnosis
