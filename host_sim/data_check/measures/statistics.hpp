// What one channel says about itself.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

struct Statistics {
  double mean = 0.0, rms = 0.0;  // rms about the mean
  double lowest = 0.0, highest = 0.0;
  double range = 0.0;       // between the 0.1 and 99.9 percent quantiles: a spike does not widen it
  double noise = 0.0;       // standard deviation of what is white from sample to sample
  double resolution = 0.0;  // the step of a quantised channel; 0 where none shows
  bool noisy = false;       // noise amid which equal neighbours are chance: not a smooth or coarse signal
  double repeats = 0.0;     // share of samples inside the range that equal their predecessor
};

struct MeanAndRms {
  double mean = 0.0, rms = 0.0;  // rms about the mean
};
MeanAndRms mean_and_rms(const std::vector<double>& values);  // 0 of nothing; of a constant the rms is 0 to the last bit

bool is_constant(const Channel& channel);  // all its values are equal

Statistics statistics_of(const Channel& channel);
std::vector<Statistics> statistics_of(const Record& record);  // of each channel

// How lively a stretch is: mean square of steps over `lag` samples within it; 0 where it holds none.
double mean_square_step(const std::vector<double>& values, size_t first, size_t end, size_t lag);

// When a sample was taken, in the file's own seconds, to a thousandth of the record's length.
std::string said_instant_s(const Record& record, double sample);
// The same to the sample, with its number in the file where it has one: "17.6 s (sample 1661)".
std::string said_sample(const Record& record, size_t sample);

// Runs of at least `shortest` equal values.
struct Run {
  size_t first = 0, length = 0;
};
std::vector<Run> equal_runs(const std::vector<double>& values, size_t shortest);

}  // namespace host_sim::data_check
