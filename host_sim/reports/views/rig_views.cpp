#include "host_sim/reports/views/rig_views.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/reports/views/balance_views.hpp"
#include "host_sim/reports/views/response_views.hpp"
#include "host_sim/reports/views/spectrum.hpp"

namespace host_sim::reports {
namespace {

constexpr size_t kCells = 24;        // of a map, to each side
constexpr size_t kFewestInCell = 3;  // samples: below, a mean says nothing

class Cells {
 public:
  Cells(const std::vector<double>& x, const std::vector<double>& y) : x_(range(x)), y_(range(y)) {}
  bool empty() const { return !(x_.second > x_.first) || !(y_.second > y_.first); }
  size_t cell(double x, double y) const { return index(y, y_) * kCells + index(x, x_); }
  std::pair<double, double> x() const { return x_; }
  std::pair<double, double> y() const { return y_; }

 private:
  static std::pair<double, double> range(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
  }
  static size_t index(double value, std::pair<double, double> range) {
    const double share = (value - range.first) / (range.second - range.first);
    return std::min(kCells - 1, static_cast<size_t>(std::max(0.0, share) * static_cast<double>(kCells)));
  }
  std::pair<double, double> x_, y_;
};

ForceStateMap map_of(const rig_file::RigModel& rig, size_t index, const ForceBalance& balance) {
  const rig_file::Link& link = rig.links[index];
  const LinkBalance& at = balance.links[index];
  ForceStateMap map;
  const Cells cells(at.elongation, at.rate);
  if (cells.empty()) return map;
  const bool rotates = rig_file::link_rotates(rig, link);
  map.link = rig_file::link_label(link);
  map.force_unit = quantity_unit(Quantity::kForce, rotates);
  map.elongation_unit = quantity_unit(Quantity::kDisplacement, rotates);
  map.rate_unit = quantity_unit(Quantity::kVelocity, rotates);
  map.columns = map.rows = kCells;
  map.elongation_low = cells.x().first, map.elongation_high = cells.x().second;
  map.rate_low = cells.y().first, map.rate_high = cells.y().second;
  const Series model = at.terms.empty() ? Series(at.elongation.size(), 0.0) : at.total();
  const Series residual = at_link(link, balance);
  std::vector<size_t> count(kCells * kCells, 0);
  map.measured.assign(kCells * kCells, 0.0);
  map.model.assign(kCells * kCells, 0.0);
  for (size_t i = 0; i < at.elongation.size(); ++i) {
    const size_t cell = cells.cell(at.elongation[i], at.rate[i]);
    ++count[cell];
    map.model[cell] += model[i];
    map.measured[cell] += model[i] + residual[i];
  }
  for (size_t c = 0; c < count.size(); ++c) {
    const double n =
        count[c] < kFewestInCell ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(count[c]);
    map.measured[c] /= n;
    map.model[c] /= n;
  }
  return map;
}

void add_maps(const rig_file::RigModel& rig, const Record& record, const ForceBalance& balance, RigViews& views) {
  bool left_out = false;
  for (size_t l = 0; l < rig.links.size(); ++l) {
    if (!elongation_measured(record, rig.links[l])) {
      left_out = true;
      continue;
    }
    ForceStateMap map = map_of(rig, l, balance);
    if (map.columns > 0) views.maps.push_back(std::move(map));
  }
  if (left_out)
    views.notes.push_back(
        "without displacement sensors the elongation of a link is not known (integrated accelerations drift): no map "
        "of "
        "its force");
}

void add_residuals(const rig_file::RigModel& rig, const Record& record, const ForceBalance& balance, RigViews& views) {
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const Spectrum residual = power_spectrum(balance.residual[i], record.sample_period_s);
    const Spectrum reference = power_spectrum(balance.reference[i], record.sample_period_s);
    if (residual.density.empty()) continue;
    views.residuals.push_back({static_cast<int>(i + 1), quantity_unit(Quantity::kForce, rig.dofs[i].rotating),
                               residual.frequency_Hz, residual.density, reference.density});
  }
}

// Does every DOF have a displacement or velocity sensor? Where only accelerations are, forces of springs and dampers
// come from drifting integrals.
bool motion_measured(const rig_file::RigModel& rig, const Record& record) {
  for (int dof = 1; dof <= static_cast<int>(rig.dofs.size()); ++dof)
    if (record.find(Quantity::kDisplacement, dof) == nullptr) return false;
  return true;
}

}  // namespace

bool elongation_measured(const Record& record, const rig_file::Link& link) {
  const auto known = [&](int end) {
    return end == rig_file::kGround || record.find(Quantity::kDisplacement, end) != nullptr;
  };
  return known(link.a) && known(link.b);
}

RigViews rig_views(const rig_file::RigModel& rig, const std::vector<Record>& records,
                   const std::vector<Record>& simulated) {
  RigViews views;
  add_responses(rig, records, simulated, views);
  const Record& first = records.front();
  if (first.samples() <= 2 * kDerivativeMargin) return views;
  if (records.size() > 1)
    views.one_record = std::filesystem::path(first.file).filename().string() + ", the first of " +
                       std::to_string(records.size()) + " records";
  const ForceBalance balance = force_balance(rig, first);
  add_maps(rig, first, balance, views);
  if (motion_measured(rig, first)) add_residuals(rig, first, balance, views);
  return views;
}

std::vector<ModeRow> mode_rows(const std::vector<UncertainMode>& modes) {
  std::vector<ModeRow> rows;
  for (const UncertainMode& mode : modes) {
    ModeRow row{{mode.frequency_Hz.value, mode.frequency_Hz.low, mode.frequency_Hz.high},
                {mode.damping_ratio.value, mode.damping_ratio.low, mode.damping_ratio.high},
                {}};
    for (const std::complex<double>& value : mode.shape)
      row.shape.push_back(std::copysign(std::abs(value), value.real()));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<ModeRow> mode_rows(const rig_file::RigModel& rig) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<UncertainMode> modes;
  for (const Mode& mode : modes_of(rig))
    modes.push_back({{mode.frequency_Hz, kNone, kNone}, {mode.damping_ratio, kNone, kNone}, mode.shape});
  return mode_rows(modes);
}

}  // namespace host_sim::reports
