// One frame as readable lines; remembers the names that description frames gave.
#pragma once
#include <map>
#include <ostream>
#include <string>

#include "host_sim/can_log/candump_line.hpp"
#include "host_sim/can_log/known_causes.hpp"
#include "host_sim/can_log/known_names.hpp"

namespace can_log {

class FramePrinter {
 public:
  FramePrinter(std::ostream& output, bool changes_only) : output_(output), changes_only_(changes_only) {}
  // False where the frame is not of this protocol (it is shown by its bytes).
  bool print(const LogEntry& entry);

 private:
  void line(const std::string& text);
  void known_frame(const firmware::can::Address& address, const firmware::CanFrame& message);
  void estimate(int node, int index, int bit_offset, const firmware::CanFrame& message);
  void float_estimates(const firmware::can::Address& address, const firmware::CanFrame& message);
  void parameter(const firmware::CanFrame& message);
  void channel_description(const firmware::can::Address& address, const firmware::CanFrame& message);
  void sensor(const firmware::can::Address& address, const firmware::CanFrame& message);
  void emergency(const firmware::CanFrame& message);
  void identity(const firmware::CanFrame& message);
  void diagnosis(const firmware::CanFrame& message);
  void diagnosis_size(const firmware::CanFrame& message);
  void every_signal(const firmware::can::FrameDescription& frame, const firmware::CanFrame& message);
  bool unknown_frame(const LogEntry& entry, const firmware::CanFrame& message);

  std::ostream& output_;
  bool changes_only_;
  std::string time_;
  std::string lead_;  // interface, sender and frame of the lines being written
  KnownNames names_;
  KnownCauses causes_;
  std::map<std::string, std::string> last_;  // what each signal said last, where only changes are wanted
};

}  // namespace can_log
