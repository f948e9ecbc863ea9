#include "host_sim/reports/zoom/zoom.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/zoom/dygraphs.hpp"
#include "host_sim/reports/zoom/zoom_script.hpp"

namespace host_sim::reports {
namespace {

using nlohmann::ordered_json;

constexpr size_t kPointsOfAll = 110000;  // 2.7 bytes each: 300 kB of a page that stays under 2 MB

void add_curve(std::vector<ZoomCurve>& curves, const char* label, Role role, const std::vector<double>& values) {
  const bool fits = !values.empty() && (curves.empty() || values.size() == curves.front().values->size());
  if (fits) curves.push_back({label, role, &values});
}

// The variable's name without "var(" and ")".
std::string variable_of(Role role) {
  const std::string text = role_variable(role);
  return text.substr(4, text.size() - 5);
}

ordered_json json_of(const ZoomRecord& record, size_t bins) {
  double low = 0.0, high = 0.0;
  for (const ZoomCurve& curve : record.curves)
    for (double value : *curve.values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (!(high > low)) high = low + 1.0;
  const Prefix prefix = best_prefix(std::max(-low, high), record.unit);
  ordered_json curves = ordered_json::array();
  size_t points = 0;
  for (const ZoomCurve& curve : record.curves) {
    const std::vector<double> thin = thinned(*curve.values, bins);
    points = thin.size();
    curves.push_back(
        {{"label", curve.label}, {"colour", variable_of(curve.role)}, {"values", packed(thin, low, high)}});
  }
  const double length_s = record.period_s * static_cast<double>(record.curves.front().values->size());
  return {
      {"title", record.title},      {"quantity", record.quantity + " (" + prefix.symbol + unit_text(record.unit) + ")"},
      {"start", record.start_s},    {"step", length_s / static_cast<double>(points)},
      {"low", low * prefix.factor}, {"high", high * prefix.factor},
      {"curves", std::move(curves)}};
}

// "</script>" in a title would end the script.
std::string inside_script(std::string json) {
  for (size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.insert(at + 1, "\\");
  return json;
}

}  // namespace

std::string packed(const std::vector<double>& values, double low, double high) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes, out;
  for (double value : values) {
    const double share = std::isfinite(value) ? (value - low) / (high - low) : 0.5;
    const auto code =
        static_cast<uint16_t>(static_cast<int16_t>(std::lround(65534.0 * std::clamp(share, 0.0, 1.0)) - 32767));
    bytes += static_cast<char>(code & 0xFF);
    bytes += static_cast<char>(code >> 8);
  }
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](size_t at) { return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0u; };
    const unsigned word = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::vector<double> thinned(const std::vector<double>& values, size_t bins) {
  if (values.size() <= 2 * bins) return values;
  std::vector<double> out;
  for (size_t bin = 0; bin < bins; ++bin) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(bin * values.size() / bins);
    const auto last = values.begin() + static_cast<std::ptrdiff_t>((bin + 1) * values.size() / bins);
    const auto [low, high] = std::minmax_element(first, last);
    out.push_back(low < high ? *low : *high);
    out.push_back(low < high ? *high : *low);
  }
  return out;
}

std::vector<ZoomRecord> zoom_records(const std::vector<DofView>& views) {
  std::vector<ZoomRecord> out;
  for (const DofView& view : views)
    for (const Waveform& waveform : view.waveforms) {
      ZoomRecord record{"DOF " + std::to_string(view.dof) + " " + waveform.quantity,
                        waveform.quantity,
                        waveform.unit,
                        view.start_s,
                        view.period_s,
                        {}};
      add_curve(record.curves, "measured", Role::kMeasured, waveform.measured);
      add_curve(record.curves, "rig as given", Role::kGiven, waveform.simulated);
      add_curve(record.curves, "extended rig", Role::kExtended, waveform.extended);
      if (!record.curves.empty()) out.push_back(std::move(record));
    }
  return out;
}

std::vector<ZoomRecord> zoom_records(const RunRecord& from) {
  std::vector<ZoomRecord> out;
  for (const RunAcceleration& acceleration : from.accelerations) {
    ZoomRecord record{from.label + ", DOF " + std::to_string(acceleration.dof) + " acceleration",
                      "acceleration",
                      acceleration.unit,
                      from.start_s,
                      from.period_s,
                      {}};
    add_curve(record.curves, "of the rig", Role::kTruth, acceleration.measured);
    add_curve(record.curves, "simulated", Role::kGiven, acceleration.simulated);
    if (!record.curves.empty()) out.push_back(std::move(record));
  }
  return out;
}

void add_zoom(Page& page, const std::vector<ZoomRecord>& records) {
  if (records.empty() || *dygraphs_script() == '\0') return;
  size_t curves = 0;
  for (const ZoomRecord& record : records) curves += record.curves.size();
  ordered_json all = ordered_json::array();
  for (const ZoomRecord& record : records) all.push_back(json_of(record, kPointsOfAll / (2 * curves)));
  page.section("zoom", "Look closer",
               "Drag across a picture to zoom in, double-click to see all again, hold shift and drag to move. Both "
               "pictures keep the same time. The lower one shows the error, simulated less measured.");
  page.html(std::string("<style>") + dygraphs_style() + "</style>\n" + kZoomFrame +
            "<script type=\"application/json\" id=\"zoom-records\">" +
            inside_script(all.dump(-1, ' ', false, ordered_json::error_handler_t::replace)) + "</script>\n<script>" +
            dygraphs_script() + "</script>\n<script>" + kZoomScript + "</script>\n");
}

}  // namespace host_sim::reports
