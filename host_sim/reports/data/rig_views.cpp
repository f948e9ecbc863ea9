#include "host_sim/reports/data/rig_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/reports/data/spectrum.hpp"
#include "host_sim/response/frequency_response.hpp"

namespace host_sim::reports {
namespace {

constexpr size_t kCells = 24;          // of a map, to each side
constexpr size_t kFewestInCell = 3;    // samples: below, a mean says nothing
constexpr size_t kMostResponses = 12;  // pictures; beyond, of the driven DOFs alone

// The fastest motion of a DOF that is measured: accelerations show the most modes.
const Channel* motion_of(const Record& record, int dof) {
  for (Quantity quantity : {Quantity::kAcceleration, Quantity::kVelocity, Quantity::kDisplacement})
    if (const Channel* channel = record.find(quantity, dof)) return channel;
  return nullptr;
}

std::vector<double> magnitudes(const FrequencyResponse& response) {
  std::vector<double> out;
  for (const std::complex<double>& value : response.response) out.push_back(std::abs(value));
  return out;
}

// The force of one DOF and the motion of another in all records.
class ResponsePair {
 public:
  ResponsePair(const std::vector<Record>& records, const std::vector<Record>& simulated, int driven, int moved)
      : records_(records), driven_(driven), moved_(moved) {
    for (size_t i = 0; i < records.size(); ++i) {
      const Channel* force = records[i].find(Quantity::kForce, driven);
      const Channel* motion = motion_of(records[i], moved);
      if (force == nullptr || motion == nullptr) continue;
      measured_.push_back({&force->values, &motion->values});
      if (i < simulated.size())
        simulated_.push_back({&force->values, &simulated[i].find(motion->quantity, moved)->values});
    }
  }

  bool any() const { return !measured_.empty(); }

  ResponseView view(size_t segment) const {
    const Record& first = records_.front();
    const Channel& motion = *motion_of(first, moved_);
    const bool rotates = channel_rotates(motion);
    const bool drive_rotates = channel_rotates(*first.find(Quantity::kForce, driven_));
    const FrequencyResponse measured = frequency_response(measured_, first.sample_period_s, segment);
    ResponseView out;
    const std::string force = quantity_word(Quantity::kForce, drive_rotates);
    out.title = channel_words(motion) + " per " + force + " on DOF " + std::to_string(driven_);
    out.label = quantity_word(motion.quantity, rotates) + " per " + force;
    const std::string per = quantity_unit(Quantity::kForce, drive_rotates);
    out.unit = quantity_unit(motion.quantity, rotates) + "/" + (drive_rotates ? "(" + per + ")" : per);
    out.frequency_Hz = measured.frequency_Hz;
    out.measured = magnitudes(measured);
    out.coherence = measured.coherence;
    out.segments = measured.segments;
    if (!simulated_.empty()) out.simulated = magnitudes(frequency_response(simulated_, first.sample_period_s, segment));
    return out;
  }

 private:
  const std::vector<Record>& records_;
  int driven_, moved_;
  std::vector<SignalPair> measured_, simulated_;
};

// A force that stands still drives nothing.
bool drives(const Record& record, int dof) {
  const Channel* force = record.find(Quantity::kForce, dof);
  if (force == nullptr) return false;
  const auto [low, high] = std::minmax_element(force->values.begin(), force->values.end());
  return *high > *low;
}

void add_responses(const rig_file::RigModel& rig, const std::vector<Record>& records,
                   const std::vector<Record>& simulated, RigViews& views) {
  size_t shortest = std::numeric_limits<size_t>::max();
  for (const Record& record : records) shortest = std::min(shortest, record.samples());
  const size_t segment = response_segment(shortest);
  const int dofs = static_cast<int>(rig.dofs.size());
  std::vector<int> driven;
  for (int dof = 1; dof <= dofs; ++dof)
    if (drives(records.front(), dof)) driven.push_back(dof);
  if (driven.empty()) {
    views.notes.push_back("no force is measured: there is no frequency response");
    return;
  }
  if (segment == 0) {
    views.notes.push_back("the record is too short for a frequency response");
    return;
  }
  const bool all = driven.size() * static_cast<size_t>(dofs) <= kMostResponses;
  for (int from : driven)
    for (int to = 1; to <= dofs; ++to) {
      const ResponsePair pair(records, simulated, from, to);
      if (pair.any() && (all || from == to)) views.responses.push_back(pair.view(segment));
    }
}

// The force that this link alone would have to add to make up for the residuals of its ends (least squares).
double share_of_residual(const rig_file::Link& link, const ForceBalance& balance, size_t sample) {
  const double at_a = balance.residual[static_cast<size_t>(link.a - 1)][sample];
  return link.b <= 0 ? at_a : 0.5 * (at_a - balance.residual[static_cast<size_t>(link.b - 1)][sample]);
}

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
  std::vector<size_t> count(kCells * kCells, 0);
  map.measured.assign(kCells * kCells, 0.0);
  map.model.assign(kCells * kCells, 0.0);
  for (size_t i = 0; i < at.elongation.size(); ++i) {
    const size_t cell = cells.cell(at.elongation[i], at.rate[i]);
    ++count[cell];
    map.model[cell] += model[i];
    map.measured[cell] += model[i] + share_of_residual(link, balance, i);
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
