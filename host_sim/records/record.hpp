// Measured or simulated data in SI units: what a CSV, a MAT or UFF file or a sensor log is read into.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace host_sim {

enum class Quantity { kForce, kDisplacement, kVelocity, kAcceleration };

struct Channel {
  std::string name;  // as in the data file: "displacement_1_m"
  Quantity quantity = Quantity::kDisplacement;
  int dof = 1;  // from 1; rig_file::kBase (-1) for the moving base
  std::vector<double> values;
  double recorded_step = 0.0;  // of interpolated values: the step in which they were recorded; else 0
  bool held = false;           // a command that stays from one change to the next: between samples there is nothing
  double update_s = 0.0;       // of interpolated values: how long the sensor held each (updates.hpp); else 0
};

// Who told the sample times: a column of the file, its own frames or header, or the user (--sample-rate).
enum class TimesFrom { kColumn, kFile, kUser };

struct Record {
  std::string file;
  double sample_period_s = 0.0;
  double start_s = 0.0;
  std::vector<Channel> channels;  // all of one length
  std::vector<double> time_s;     // of samples at uneven times, to be resampled; else empty
  TimesFrom times_from = TimesFrom::kColumn;
  double own_step_s = 0.0;     // of channels in rows of their own, or interpolated: usual step of the fastest; else 0
  double time_jitter_s = 0.0;  // rms of the file's sample times about even steps; 0 where it has none
  // The file's samples before the first of these; none where these are no samples of the file, or where some between them are left out.
  std::optional<size_t> left_out_before = 0;
  std::vector<std::string> computed;  // names of columns that were computed from others and are left out
  std::vector<std::string> notes;     // what the reader made of the file: factors, ignored columns
  size_t samples() const { return channels.empty() ? 0 : channels.front().values.size(); }
  const Channel* find(Quantity quantity, int dof) const {
    for (const Channel& channel : channels)
      if (channel.quantity == quantity && channel.dof == dof) return &channel;
    return nullptr;
  }
};

}  // namespace host_sim
