#include "host_sim/records/columns/names/column_name.hpp"

#include <algorithm>
#include <cctype>

#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {
namespace {

std::string lowered(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (c == ' ') c = '_';
  }
  return text;
}

// The DOF that begins at `at` ("12" or "base"); moves behind it. 0: none.
int take_dof(const std::string& text, size_t& at) {
  if (text.compare(at, 4, "base") == 0) {
    at += 4;
    return rig_file::kBase;
  }
  int dof = 0;
  const size_t start = at;
  while (at < text.size() && at < start + 4 && std::isdigit(static_cast<unsigned char>(text[at])) != 0)
    dof = dof * 10 + (text[at++] - '0');
  return at == start || text[start] == '0' ? 0 : dof;
}

// "Position (m) Run #1": a unit in brackets with more behind it, which is passed over.
void take_inner_unit(HeadParts& parts) {
  for (const char* brackets : {"()", "[]", "{}"}) {
    const size_t open = parts.name.find(brackets[0]), close = parts.name.find(brackets[1], open);
    if (open == std::string::npos || open == 0 || close == std::string::npos) continue;
    const std::string unit = trimmed_text(parts.name.substr(open + 1, close - open - 1));
    if (!find_unit(unit)) continue;
    parts.unit = unit;
    parts.name = trimmed_text(parts.name.substr(0, open));
    return;
  }
}

// "Time/s", "Angle / rad", "w/rad/s": a quantity divided by its unit. A head that is a unit ("m/s") is none.
void take_unit_behind_slash(HeadParts& parts) {
  const size_t slash = parts.name.find('/');
  if (slash == std::string::npos || slash == 0 || find_unit(parts.name)) return;
  const std::string unit = trimmed_text(parts.name.substr(slash + 1));
  if (!find_unit(unit)) return;
  parts.unit = unit;
  parts.name = trimmed_text(parts.name.substr(0, slash));
}

}  // namespace

std::string trimmed_text(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t\r\"'");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"'") - first + 1);
}

HeadParts split_head(const std::string& head) {
  HeadParts parts{trimmed_text(head), ""};
  const std::string& whole = parts.name;
  for (const char* brackets : {"()", "[]", "{}"}) {
    if (whole.empty() || whole.back() != brackets[1]) continue;
    int depth = 0;
    for (size_t at = whole.size(); at-- > 0;) {  // "force_1 (kN)", "a (m/(s^2))"
      if (whole[at] == brackets[1]) ++depth;
      if (whole[at] == brackets[0] && --depth == 0) {
        if (at == 0) return parts;
        parts.unit = trimmed_text(whole.substr(at + 1, whole.size() - at - 2));
        parts.name = trimmed_text(whole.substr(0, at));
        return parts;
      }
    }
  }
  take_inner_unit(parts);
  if (parts.unit.empty()) take_unit_behind_slash(parts);
  return parts;
}

std::optional<NamedChannel> parse_loose_name(const std::string& name) {
  using rig_file::ChannelName;
  const std::string low = lowered(name);
  for (const bool rotating :
       {true, false}) {  // "angular_velocity" before "velocity" does not matter: both start a name
    for (int q = 0; q < 4; ++q) {
      const std::string model = rig_file::format_channel_name({static_cast<firmware::Quantity>(q), 1, rotating});
      const std::string stem = model.substr(0, model.find("_1_") + 1);
      if (low.compare(0, stem.size(), stem) != 0) continue;
      size_t at = stem.size();
      const int dof = take_dof(low, at);
      if (dof == 0 || (at < low.size() && low[at] != '_')) return std::nullopt;
      return NamedChannel{{static_cast<firmware::Quantity>(q), dof, rotating},
                          at < name.size() ? name.substr(at + 1) : std::string()};
    }
  }
  return std::nullopt;
}

bool is_time_name(const std::string& name, std::string& unit_suffix) {
  unit_suffix.clear();
  const std::string own = name.substr(std::min(name.find_first_not_of('_'), name.size()));  // __time
  const std::string low = lowered(own);
  for (const char* word : {"t", "time", "zeit", "temps", "tiempo", "tempo", "timestamp", "time_stamp", "datetime",
                           "date_time", "date/time", "x_value", "relative_time", "elapsed_time", "abscissa"}) {
    const std::string stem = word;
    if (low == stem || low == stem + "_t") return true;  // "Zeit t / s"
    if (low.compare(0, stem.size() + 1, stem + "_") != 0) continue;
    const auto unit = find_unit_suffix(own.substr(stem.size() + 1), Dimension::kTime);
    if (!unit || unit->dimension != Dimension::kTime) continue;
    unit_suffix = unit->word;
    return true;
  }
  return false;
}

bool shaped_like_channel(const std::string& name) {
  if (parse_loose_name(name)) return true;
  const std::string low = lowered(name);
  size_t at = 0;
  while (at < low.size() && (std::isalpha(static_cast<unsigned char>(low[at])) != 0 || low[at] == '_')) {
    ++at;
    if (low[at - 1] != '_' || at >= low.size()) continue;
    size_t behind = at;
    if (std::isdigit(static_cast<unsigned char>(low[at])) == 0 && low.compare(at, 4, "base") != 0) continue;
    while (behind < low.size() && std::isdigit(static_cast<unsigned char>(low[behind])) != 0) ++behind;
    if (behind == at) behind += 4;
    if (behind >= low.size() || low[behind] != '_') continue;
    const std::string suffix = name.substr(behind + 1);
    for (int d = 0; d <= static_cast<int>(Dimension::kAngularAcceleration); ++d)
      if (const auto unit = find_unit_suffix(suffix, static_cast<Dimension>(d));
          unit && unit->dimension == static_cast<Dimension>(d))
        return true;
  }
  return false;
}

}  // namespace host_sim
