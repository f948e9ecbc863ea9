#include "host_sim/records/columns/column.hpp"

#include "host_sim/records/columns/quoted.hpp"

namespace host_sim {

HeadParts parts_of(const Column& column) {
  HeadParts parts = split_head(column.head);
  if (!column.unit.empty()) parts.unit = column.unit;
  return parts;
}

std::string quoted_head(const Column& column) { return quoted(trimmed_text(column.head)); }

std::string quoted_heads(const std::vector<Column>& columns) {
  constexpr size_t kMost = 12;
  const size_t told = columns.size() <= kMost + 1 ? columns.size() : kMost;  // "and 1 more" is no shorter
  std::string heads;
  for (size_t i = 0; i < told; ++i) heads += (heads.empty() ? "" : ", ") + quoted_head(columns[i]);
  return told == columns.size() ? heads : heads + " and " + std::to_string(columns.size() - told) + " more";
}

}  // namespace host_sim
