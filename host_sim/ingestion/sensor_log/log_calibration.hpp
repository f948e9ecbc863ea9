// Which channels a sensor log carries, and what their codes mean.
#pragma once
#include <string>
#include <vector>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

struct LogChannel {
  std::string name;  // "displacement_1_m"
  int node = 0;      // index in RawSample::code
  int quantity = 0;
  double unit_per_code = 0.0;
  int32_t offset_code = 0;
};

// Collects what the frames of a log say, in any order.
class LogCalibration {
 public:
  void learn(const firmware::CanFrame& message, const std::string& file, size_t line);
  // After the last frame.
  void lay_out_pairs(const std::string& file, const rig_file::RigModel& model);
  // Which frames make a sample whole: those that the log holds.
  const firmware::SensorPlan& plan() const { return plan_; }
  bool any_sensor_frame() const { return any_sensor_frame_; }
  // The channels with a calibration: the rig file's first, else the log's. Throws DataFileError where the rig file
  // calibrates a channel that no frame of the log carries, or where there is none at all.
  std::vector<LogChannel> channels(const std::string& file, const rig_file::RigModel& model) const;

 private:
  struct Description {
    bool known = false;
    bool offset_known = false;
    bool rotating = false;
    double unit_per_code = 0.0;
    int32_t offset_code = 0;
  };
  bool carried(int node, int quantity) const;
  bool described() const;

  firmware::SensorPlan plan_;
  bool any_sensor_frame_ = false;
  Description described_[firmware::kMaxNodes][firmware::kQuantities];
};

}  // namespace host_sim
