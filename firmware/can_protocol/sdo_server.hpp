// The node's object dictionary over SDO (CiA 301): one request in, at most one answer out, no clock, no bus.
//
//   1000.0  device type           u32 ro      1010.0  1                       u8  ro
//   1001.0  error register        u8  ro      1010.1  write "save"            u32 rw
//   1005.0  SYNC identifier       u32 ro      1011.0  1                       u8  ro
//   1008.0  device name           string ro   1011.1  write "load"            u32 rw
//   1009.0  hardware version      string ro   1014.0  EMCY identifier         u32 ro
//   100A.0  firmware version      string ro   1017.0  heartbeat time in ms    u16 rw, 10 or more
//   1018.0  4                     u8  ro      1018.1 to .4  vendor, product, revision, serial number  u32 ro
//
// Values of four bytes or less travel expedited, longer strings in segments. Whatever else is asked for is answered by
// an abort with the code that CiA 301 gives for it. Saving and loading are the controller's work: the request comes
// back as an action, and its answer is sent once the controller knows how it went.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/can_message.hpp"

namespace firmware {

constexpr uint16_t kShortestHeartbeat_ms = 10;

struct ObjectValues {
  uint32_t device_type = 0;
  uint8_t error_register = 0;
  uint16_t heartbeat_ms = 100;
  uint32_t vendor_id = 0, product_code = 0, revision = 0, serial_number = 0;
  const char* device_name = "rig damping estimator";
  const char* hardware_version = "0";
  const char* firmware_version = "0";
};

enum class SdoAction : uint8_t {
  kNone,
  kHeartbeatChanged,  // values().heartbeat_ms is new; the answer is in the result already
  kSave,              // store the configuration, then send confirm()
  kLoadDefaults,      // go back to the shipped configuration, then send confirm()
};

struct SdoResult {
  bool handled = false;  // false: the frame was no request to this node
  bool has_reply = false;
  CanMessage reply;
  SdoAction action = SdoAction::kNone;
};

class SdoServer {
 public:
  SdoServer(int node, const ObjectValues& values) : node_(node), values_(values) {}
  SdoResult handle(const CanMessage& request);
  // The answer to kSave or kLoadDefaults. Until then every other request is aborted as "not in this state".
  CanMessage confirm(bool done);
  ObjectValues& values() { return values_; }

 private:
  struct Request {
    uint8_t command = 0;
    uint16_t index = 0;
    uint8_t subindex = 0;
    uint32_t data = 0;
  };
  struct Object;
  uint32_t find(uint16_t index, uint8_t subindex, Object& object) const;  // 0, or the abort code
  CanMessage reply(uint8_t command, const Request& to, uint32_t data) const;
  CanMessage abort(const Request& to, uint32_t code);
  CanMessage read(const Request& request);
  CanMessage write(const Request& request, SdoResult& result);
  CanMessage next_segment(const Request& request);

  int node_;
  ObjectValues values_;
  Request pending_;  // save or load under way
  bool waiting_ = false;
  const char* segments_ = nullptr;  // rest of the string being read; null: no transfer
  Request transfer_;
  bool toggle_ = false;
};

}  // namespace firmware
