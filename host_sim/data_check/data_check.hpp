// What is wrong with recordings, seen before anybody computes with them; docs/data_check.md.
//
// Pure functions over records. A finding has a reason with a stated error rate; where several readings of the data are
// possible the finding says so or is not there.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// Informs: nothing stops, the number is worth knowing. Doubt: estimates suffer, but there are some. Fault: the data
// cannot answer.
enum class Weight { kInforms, kDoubt, kFault };

struct Finding {
  std::string kind;  // "dead", "clipped", "spikes", "polarity", "unit", "drift", "hum", "jitter", "skew", ...
  Weight weight = Weight::kInforms;
  std::string channel;          // empty: of the whole record
  std::string detail;           // a sentence without the channel's name at its front
  std::optional<double> value;  // the number behind it: a factor, a share, a delay in s
};

struct ChannelReport {
  std::string name;
  double rms = 0.0;  // about the mean, SI
  double mean = 0.0;
  double noise_floor = 0.0;  // standard deviation of what changes from sample to sample, SI
  double resolution = 0.0;   // smallest step of the values, SI; 0: finer than shows
  std::vector<Finding> findings;
};

struct RecordReport {
  std::string file;
  size_t samples = 0;
  double sample_rate_Hz = 0.0;
  std::vector<ChannelReport> channels;
  std::vector<Finding> findings;  // of the record as a whole
};

struct Report {
  std::vector<RecordReport> records;
  std::vector<Finding> findings;  // of all records together: levels, bands
  Weight worst() const;
  const char* verdict() const;  // "good", "usable", "unusable"
};

// model: nothing where there is no rig file. records: at least one sample each; channels of one record have one length.
Report check(const std::vector<Record>& records, const rig_file::RigModel* model);

}  // namespace host_sim::data_check
