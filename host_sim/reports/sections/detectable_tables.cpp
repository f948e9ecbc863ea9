#include "host_sim/reports/sections/detectable_tables.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace host_sim::reports {
namespace {

std::string cell_of(const Detectable& limit) {
  if (!std::isfinite(limit.strength)) return "<span class=\"dim\">not in these data</span>";
  std::string cell = number_html(limit.strength, 2);
  if (limit.unit != "1") cell += " " + escaped(unit_text(limit.unit));
  const double percent = limit.percent_of_damping_force;
  return std::isfinite(percent) ? cell + "<br><span class=\"dim\">" + percent_text(percent) + " %</span>" : cell;
}

// Where a word stands in a list that it joins where it is new.
size_t index_in(std::vector<std::string>& list, const std::string& word) {
  const auto at = std::find(list.begin(), list.end(), word);
  if (at != list.end()) return static_cast<size_t>(at - list.begin());
  list.push_back(word);
  return list.size() - 1;
}

// Of the places that begin with `what`: effects by place, or places by effect.
HtmlTable pivot(const std::vector<Detectable>& limits, const std::string& what, bool rows_are_places) {
  std::vector<std::string> rows, columns;
  HtmlTable table;
  for (const Detectable& limit : limits) {
    if (limit.where.rfind(what + " ", 0) != 0) continue;
    const std::string effect = cause_text(limit.effect, ""), place = limit.where.substr(what.size() + 1);
    const size_t row = index_in(rows, rows_are_places ? place : effect),
                 column = index_in(columns, rows_are_places ? effect : what + " " + place);
    table.rows.resize(rows.size());
    auto& cells = table.rows[row];
    cells.resize(std::max(cells.size(), column + 2));
    cells[0] = escaped(rows[row]), cells[column + 1] = cell_of(limit);
  }
  table.heading = {rows_are_places ? what : "effect"}, table.numeric = {false};
  for (const std::string& column : columns) table.heading.push_back(escaped(column)), table.numeric.push_back(true);
  for (auto& cells : table.rows) cells.resize(table.heading.size());
  return table;
}

}  // namespace

std::vector<HtmlTable> detectable_tables(const std::vector<Detectable>& limits) {
  std::vector<HtmlTable> list;
  for (const char* what : {"link", "dof", "channel"}) {
    HtmlTable table = pivot(limits, what, std::string(what) == "channel");
    if (!table.rows.empty()) list.push_back(std::move(table));
  }
  return list;
}

}  // namespace host_sim::reports
