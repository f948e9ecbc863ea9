// The column that holds the times, and its factor to seconds.
#pragma once
#include <optional>
#include <vector>

#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/column_meaning.hpp"
#include "host_sim/records/columns/plan/column_context.hpp"

namespace host_sim {

// chosen: by the user; else t_s, else the first with a usual name of time that is nothing else. None where a sample rate is given.
void take_time(const ColumnContext& context, const std::vector<Column>& columns, std::optional<size_t> chosen,
               ColumnPlan& plan);

}  // namespace host_sim
