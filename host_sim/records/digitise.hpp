// Records as converter codes: what the board's sensors would have delivered.
#pragma once
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// One calibration per channel, in the order of the first record's channels, the same for all records. Where the rig's
// [[channel]] gives unit_per_code it is used; else the unit is the power of two that puts the largest value of all
// records between 2^22 and 2^23 codes, so that rounding moves no value by more than 2^-23 of the channel's largest.
std::vector<rig_file::ChannelCalibration> calibrate(const std::vector<Record>& records,
                                                    const rig_file::RigModel& model);

// Value to code: rounded to nearest, ties to even; beyond full scale it stays at full scale.
int32_t to_code(double value, const rig_file::ChannelCalibration& calibration);

// Replays one record sample by sample. The record and the calibrations must outlive it.
class RecordSampleSource : public hal::SampleSource {
 public:
  RecordSampleSource(const Record& record, const std::vector<rig_file::ChannelCalibration>& calibrations);
  hal::SampleResult read(firmware::RawSample& sample) override;

 private:
  struct Column {
    const std::vector<double>* values;
    const rig_file::ChannelCalibration* calibration;
    int node, quantity;
  };
  std::vector<Column> columns_;
  size_t next_ = 0, count_ = 0;
  double sample_period_s_ = 0.0;
};

}  // namespace host_sim
