#include "host_sim/reports/views/response_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/response/frequency_response.hpp"

namespace host_sim::reports {
namespace {

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

}  // namespace

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

}  // namespace host_sim::reports
