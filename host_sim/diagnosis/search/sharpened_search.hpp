// The search, repeated with what it found out about the motion.
#pragma once
#include <memory>

#include "../first_screen/bench.hpp"
#include "search.hpp"

namespace diagnosis {

// Again with the motion that the found terms sharpen: they move the reversals of friction and, in steps, the slow motion
// where that is not measured. The bench is then that of the last search.
SearchResult search_sharpening(std::unique_ptr<Bench>& bench);

}  // namespace diagnosis
