#include "host_sim/live/screen/screen.hpp"

#include <algorithm>

#include "host_sim/live/screen/estimate_table.hpp"
#include "host_sim/live/screen/status_lines.hpp"

namespace live {
namespace {

constexpr int kFewestRows = 2, kFewestEvents = 2, kMostEvents = 8;

Line title(const BusPicture& picture, const View& view) {
  std::string text = "host_sim watch " + view.source;
  if (picture.nodes().size() > 1) {
    text += "  nodes";
    for (const int number : picture.nodes())
      text += number == view.node ? " [" + std::to_string(number) + "]" : " " + std::to_string(number);
  }
  const std::string elapsed = duration_text(time_since(picture.start_ns(), picture.now_ns()));
  const int room = view.width - columns_of(elapsed);
  return {{padded(cut(text, room - 1, view.unicode), room) + elapsed, Role::kTitle}};
}

struct Parts {
  std::vector<Line> head;
  int rows = 0, events = 0;  // how many of each are shown
};

// The head and the diagnosis are always there; table and alarms share the rest, the table first.
Parts lay_out(const BusPicture& picture, const View& view) {
  Parts parts;
  parts.head.push_back(title(picture, view));
  for (const Line& line : flow(bus_fields(picture, view.ended), view.width, view.unicode)) parts.head.push_back(line);
  for (const Line& line : flow(node_fields(picture, view.node), view.width, view.unicode)) parts.head.push_back(line);
  parts.head.emplace_back();
  const int rows = static_cast<int>(picture.node(view.node).estimates.size());
  const int events = std::min<int>(kMostEvents, static_cast<int>(picture.events().size()));
  parts.rows = rows;
  parts.events = events;
  if (view.height <= 0) return parts;
  const int fixed = static_cast<int>(parts.head.size()) + 4;  // head of the table, diagnosis, head of alarms, prompt
  const int room = std::max(kFewestRows, view.height - fixed);
  parts.rows = std::min(rows, std::max(kFewestRows, room - std::min(events, kFewestEvents)));
  parts.events = std::clamp(room - parts.rows, 0, events);
  return parts;
}

Line diagnosis_line(const BusPicture& picture, const View& view, int first_row, int rows) {
  const Span words = diagnosis_field(picture.node(view.node));
  Line line = {{cut(words.text, view.width, view.unicode), words.role}};
  const int total = static_cast<int>(picture.node(view.node).estimates.size());
  const std::string shown = "  rows " + std::to_string(first_row + 1) + " to " + std::to_string(first_row + rows) +
                            " of " + std::to_string(total);
  if (rows < total && columns_of(line) + columns_of(shown) <= view.width) line.push_back({shown, Role::kQuiet});
  return line;
}

Line alarm_head(const BusPicture& picture, int shown) {
  if (picture.events().empty()) return {{"alarms: none", Role::kQuiet}};
  const int older = static_cast<int>(picture.events().size()) - shown;
  return {{older > 0 ? "alarms (" + std::to_string(older) + " older):" : "alarms:", Role::kPlain}};
}

}  // namespace

int last_first_row(const BusPicture& picture, const View& view) {
  return std::max(0, static_cast<int>(picture.node(view.node).estimates.size()) - lay_out(picture, view).rows);
}

std::vector<Line> draw(const BusPicture& picture, const View& view) {
  const Parts parts = lay_out(picture, view);
  std::vector<Line> lines = parts.head;
  const int total = static_cast<int>(picture.node(view.node).estimates.size());
  TableView table;
  table.width = view.width;
  table.unicode = view.unicode;
  table.first_row = std::clamp(view.first_row, 0, std::max(0, total - parts.rows));
  table.most_rows = parts.rows;
  if (total > 0) {
    for (const Line& line : estimate_table(picture, view.node, table)) lines.push_back(line);
  } else {
    lines.push_back({{"no estimates yet", Role::kQuiet}});
  }
  lines.push_back(diagnosis_line(picture, view, table.first_row, parts.rows));
  lines.push_back(alarm_head(picture, parts.events));
  for (size_t i = picture.events().size() - static_cast<size_t>(parts.events); i < picture.events().size(); ++i) {
    const Span event = event_field(picture.events()[i], picture.start_ns());
    lines.push_back({{cut(event.text, view.width, view.unicode), event.role}});
  }
  if (view.prompt.empty()) return lines;
  while (static_cast<int>(lines.size()) < view.height - 1) lines.emplace_back();
  lines.push_back({{cut(view.prompt, view.width, view.unicode), view.prompt_asks ? Role::kTitle : Role::kQuiet}});
  return lines;
}

}  // namespace live
