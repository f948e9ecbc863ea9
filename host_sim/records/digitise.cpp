#include "host_sim/records/digitise.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"

namespace host_sim {
namespace {

constexpr int kCodeBits = 23;  // and a sign

// The nearest whole number, of two the even one, without a call: nothing behind the point is left beside 1.5 * 2^52. Beyond 2^51 it
// may be an even one beside it.
double nearest_whole(double value) {
  constexpr double kNoFraction = 0x1.8p52;
  return (value + kNoFraction) - kNoFraction;
}

double largest(const std::vector<Record>& records, const Channel& like) {
  double result = 0.0;
  for (const Record& record : records)
    if (const Channel* channel = record.find(like.quantity, like.dof))
      for (const double value : channel->values) result = std::max(result, std::abs(value));
  return result;
}

// The largest code must stay below full scale, 2^23 - 1, also after rounding. Of a channel that is zero throughout (a drive that is off) one
// SI unit is full scale: what filters round of its codes is then no force beside that of any rig.
double power_of_two_unit(double largest_value) {
  if (largest_value == 0.0) return std::ldexp(1.0, -kCodeBits);
  int exponent = 0;
  std::frexp(largest_value, &exponent);  // 2^(exponent - 1) <= value < 2^exponent
  const double unit = std::ldexp(1.0, exponent - kCodeBits);
  return std::nearbyint(largest_value / unit) >= 8388607.0 ? 2.0 * unit : unit;
}

// Rails that the rig file leaves out lie beyond all that was recorded, twice as far or more: the core takes the range of its force laws
// from them, and 16-bit codes in a range of 24 bits have no cube.
void put_rails_beyond(double largest_value, rig_file::ChannelCalibration& calibration) {
  int exponent = 0;
  std::frexp(largest_value / calibration.unit_per_code, &exponent);
  const int32_t span = exponent + 1 >= kCodeBits ? firmware::kLargestCode : 1 << std::max(exponent + 1, 1);
  calibration.lowest_code = std::max(calibration.offset_code - span, -firmware::kLargestCode);
  calibration.highest_code = std::min(calibration.offset_code + span, firmware::kLargestCode);
}

}  // namespace

std::vector<rig_file::ChannelCalibration> calibrate(const std::vector<Record>& records,
                                                    const rig_file::RigModel& model) {
  std::vector<rig_file::ChannelCalibration> calibrations;
  for (const Channel& channel : records.front().channels) {
    rig_file::ChannelCalibration calibration;
    calibration.quantity = static_cast<firmware::Quantity>(channel.quantity);
    calibration.dof = channel.dof;
    const rig_file::ChannelEntry* const entry = rig_file::entry_of(model, channel.name);
    if (entry != nullptr) calibration.take(*entry);
    if (entry == nullptr || entry->unit_per_code == 0.0) {
      calibration.unit_per_code = power_of_two_unit(largest(records, channel));
      calibration.offset_code = 0;
      calibration.lowest_code = -firmware::kLargestCode;
      calibration.highest_code = firmware::kLargestCode;
    } else if (entry->lowest_code == entry->highest_code) {
      put_rails_beyond(largest(records, channel), calibration);
    }
    calibrations.push_back(calibration);
  }
  return calibrations;
}

int32_t to_code(double value, const rig_file::ChannelCalibration& calibration) {
  const double code = nearest_whole(value / calibration.unit_per_code) + calibration.offset_code;
  return static_cast<int32_t>(std::clamp<double>(code, calibration.lowest_code, calibration.highest_code));
}

RecordSampleSource::RecordSampleSource(const Record& record,
                                       const std::vector<rig_file::ChannelCalibration>& calibrations)
    : count_(record.samples()), sample_period_s_(record.sample_period_s) {
  for (const rig_file::ChannelCalibration& calibration : calibrations)
    if (const Channel* channel = record.find(static_cast<Quantity>(calibration.quantity), calibration.dof))
      columns_.push_back({&channel->values, &calibration, rig_file::node_index(calibration.dof),
                          static_cast<int>(calibration.quantity)});
}

hal::SampleResult RecordSampleSource::read(firmware::RawSample& sample) {
  if (next_ == count_) return hal::SampleResult::kEnd;
  sample.sequence = static_cast<uint32_t>(next_);
  sample.time_ns = static_cast<uint64_t>(std::llround(static_cast<double>(next_) * sample_period_s_ * 1e9));
  for (const Column& column : columns_)
    sample.code[column.node][column.quantity] = to_code((*column.values)[next_], *column.calibration);
  ++next_;
  return hal::SampleResult::kSample;
}

}  // namespace host_sim
