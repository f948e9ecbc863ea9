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
  std::string heads;
  for (const Column& column : columns) heads += (heads.empty() ? "" : ", ") + quoted_head(column);
  return heads;
}

}  // namespace host_sim
