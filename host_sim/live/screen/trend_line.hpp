// A trend as a line of small blocks.
#pragma once
#include <string>

#include "host_sim/live/state/trend.hpp"

namespace live {

// `columns` characters from the first point (or `span_ns` before `now_ns`) to now: the last value of each column between
// the lowest and the highest shown; values far from the others stand at the edge. A trend that moves by less than four standard deviations is drawn as if it moved by
// four, so noise looks like noise. Columns without a point repeat the one before; blanks where there is none.
std::string trend_line(const Trend& trend, double std, uint64_t now_ns, uint64_t span_ns, int columns, bool unicode);

}  // namespace live
