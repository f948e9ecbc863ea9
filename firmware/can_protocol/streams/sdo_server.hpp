// The service-data subset of CANopen (CiA 301): reads and writes of objects of up to four bytes in one exchange,
// strings read in segments of seven. One request, one answer.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/can_frame.hpp"

namespace firmware {

// CiA 301's codes, as many as can occur here.
enum class SdoAbort : uint32_t {
  kNone = 0,
  kToggle = 0x05030000,
  kCommand = 0x05040001,
  kWriteOnly = 0x06010001,
  kReadOnly = 0x06010002,
  kNoObject = 0x06020000,
  kLength = 0x06070010,
  kNoSubindex = 0x06090011,
  kValue = 0x06090030,
  kNotStored = 0x08000020,
  kDeviceState = 0x08000022,  // not now
  kPending = 0xFFFFFFFF,      // no code of CiA 301: the answer comes later, by complete()
};

// What the node offers.
class ObjectDictionary {
 public:
  static constexpr int kLongestObject = 32;
  // bytes: the object, little-endian; size: its length, up to kLongestObject.
  virtual SdoAbort read(uint16_t index, uint8_t subindex, uint8_t (&bytes)[kLongestObject], uint8_t& size) = 0;
  virtual SdoAbort write(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size) = 0;

 protected:
  ~ObjectDictionary() = default;
};

class SdoServer {
 public:
  explicit SdoServer(ObjectDictionary& objects) : objects_(objects) {}
  // False where the request is no request to this node and needs no answer.
  bool answer(const CanFrame& request, int node, CanFrame& reply);
  // The answer to the write that was kPending.
  CanFrame complete(SdoAbort code);

 private:
  void read_object(const CanFrame& request, CanFrame& reply);
  bool write_object(const CanFrame& request, CanFrame& reply);
  void next_segment(const CanFrame& request, CanFrame& reply);
  void abort(SdoAbort code, CanFrame& reply);

  ObjectDictionary& objects_;
  uint8_t bytes_[ObjectDictionary::kLongestObject] = {};
  uint8_t size_ = 0;
  uint8_t sent_ = 0;
  bool segmented_ = false;
  bool toggle_ = false;
  CanFrame pending_;      // the beginning of the answer to the last write
  bool waiting_ = false;  // it was kPending: other writes are refused until complete()
};

}  // namespace firmware
