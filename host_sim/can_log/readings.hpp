// A frame as numbers under fixed names, for programs: what decode --csv and --json write.
#pragma once
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "firmware/can_protocol/messages/packing.hpp"
#include "host_sim/can_log/candump_line.hpp"
#include "host_sim/can_log/known_causes.hpp"
#include "host_sim/can_log/known_names.hpp"

namespace can_log {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

struct Reading {
  std::string name;          // "viscous[1-2]"; "estimate[3]" as long as its name has not been seen; "mode"
  double value = kNoNumber;  // in `unit`; of a state or of flags their number
  double std = kNoNumber;    // of an estimate
  std::string unit;          // "1" for pure numbers, states and flags
  std::string status;        // of an estimate; of a state its name; of flags their names with "|" between them
};

struct FrameReadings {
  std::string sender;  // "node 1", "DOF 3", "base", "master", "bus"; "-" where the protocol does not know the frame
  std::string frame;   // its name in the frame table; "error"; the identifier where the protocol does not know it
  std::vector<Reading> readings;
};

// Remembers what the description frames say, so feed it all frames of a log in their order.
class FrameReader {
 public:
  // False where the frame is not of this protocol; it then has one reading, "bytes", with the bytes as its status.
  bool read(const LogEntry& entry, FrameReadings& result);

 private:
  Reading estimate(int node, int index, const firmware::CanFrame& message, int bit_offset) const;
  void estimates(const firmware::can::Address& address, const firmware::CanFrame& message, FrameReadings& result) const;
  void floats(const firmware::can::Address& address, const firmware::CanFrame& message, FrameReadings& result) const;
  void sensor(const firmware::can::Address& address, const firmware::CanFrame& message, FrameReadings& result) const;
  void size(const firmware::CanFrame& message, FrameReadings& result) const;
  std::string estimate_name(int node, int index) const;

  KnownNames names_;
  KnownCauses causes_;
};

}  // namespace can_log
