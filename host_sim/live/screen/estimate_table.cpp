#include "host_sim/live/screen/estimate_table.hpp"

#include <algorithm>

#include "host_sim/can_log/readable.hpp"
#include "host_sim/live/screen/trend_line.hpp"

namespace live {
namespace {

constexpr double kHalfOf95 = 1.96;  // standard deviations
constexpr int kShortestTrend = 6, kLongestTrend = 60, kShortestName = 8, kGap = 1;

struct Row {
  std::string name, value, half, unit, status;
  const EstimateState* estimate = nullptr;
};

struct Widths {
  int name = 0, value = 0, half = 0, unit = 0, status = 0, trend = 0;
};

Row row_of(const BusPicture& picture, int node, const EstimateState& estimate, bool unicode) {
  Row row;
  row.name = picture.estimate_name(node, estimate.index);
  row.unit = picture.estimate_unit(node, estimate.index);
  row.status = estimate.status.empty() ? "-" : estimate.status;
  row.estimate = &estimate;
  if (estimate.status.empty()) return row;
  const double half = kHalfOf95 * estimate.std;
  row.value = can_log::rounded_to(estimate.value, half);
  row.half = (unicode ? "±" : "+-") + can_log::number_text(half, 2);
  return row;
}

Widths widths_of(const std::vector<Row>& rows, int width) {
  Widths widths{9, 5, 4, 4, 6, 0};  // their headings
  for (const Row& row : rows) {
    widths.name = std::max(widths.name, columns_of(row.name));
    widths.value = std::max(widths.value, columns_of(row.value));
    widths.half = std::max(widths.half, columns_of(row.half));
    widths.unit = std::max(widths.unit, columns_of(row.unit));
    widths.status = std::max(widths.status, columns_of(row.status));
  }
  const auto left = [&] {
    return width - (widths.name + widths.value + widths.half + widths.unit + widths.status + 4 * kGap);
  };
  if (left() < 0) widths.name = std::max(kShortestName, widths.name + left());
  if (left() < 0) widths.unit = std::max(1, widths.unit + left());
  widths.trend = std::clamp(left() - 2 * kGap, 0, kLongestTrend);
  if (widths.trend < kShortestTrend) widths.trend = 0;
  return widths;
}

Line head_line(const Widths& widths, const TableView& view) {
  const std::string gap(kGap, ' ');
  const std::string head = padded(cut("parameter", widths.name, view.unicode), widths.name) + gap +
                           padded("value", widths.value, true) + gap + padded("95 %", widths.half, true) + gap +
                           padded(cut("unit", widths.unit, view.unicode), widths.unit) + gap +
                           padded("status", widths.status) + (widths.trend > 0 ? gap + gap + "trend" : "");
  return {{cut(head, view.width, view.unicode), Role::kHead}};
}

}  // namespace

Role role_of_status(const std::string& status) {
  if (status == "VALID") return Role::kGood;
  for (const char* bad : {"ILL_CONDITIONED", "NO_EXCITATION", "SATURATED"})
    if (status == bad) return Role::kBad;
  return Role::kDoubtful;
}

std::vector<Line> estimate_table(const BusPicture& picture, int node, const TableView& view) {
  std::vector<Row> rows;
  for (const EstimateState& estimate : picture.node(node).estimates)
    rows.push_back(row_of(picture, node, estimate, view.unicode));
  const Widths widths = widths_of(rows, view.width);  // of all rows, so that scrolling moves no column
  const std::string gap(kGap, ' ');
  std::vector<Line> lines = {head_line(widths, view)};
  const int count = static_cast<int>(rows.size());
  for (int i = view.first_row; i < std::min(count, view.first_row + view.most_rows); ++i) {
    const Row& row = rows[static_cast<size_t>(i)];
    Line line = {{padded(cut(row.name, widths.name, view.unicode), widths.name) + gap +
                      padded(row.value, widths.value, true) + gap + padded(row.half, widths.half, true) + gap +
                      padded(cut(row.unit, widths.unit, view.unicode), widths.unit) + gap,
                  Role::kPlain},
                 {padded(row.status, widths.status), role_of_status(row.status)}};
    if (widths.trend > 0)
      line.push_back({gap + gap +
                          trend_line(row.estimate->trend, row.estimate->std, picture.now_ns(),
                                     picture.options().trend_ns, widths.trend, view.unicode),
                      Role::kPlain});
    lines.push_back(line);
  }
  return lines;
}

}  // namespace live
