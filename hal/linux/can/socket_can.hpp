// A CAN bus through the kernel's raw CAN sockets: vcan, slcan and real controllers alike. Never blocks, never allocates
// after open(), and comes back by itself when the interface does.
#pragma once
#include <linux/can.h>

#include <cstddef>
#include <string>

#include "hal/interface/can_bus.hpp"
#include "hal/linux/can/frames_in_flight.hpp"
#include "hal/linux/system/file_descriptor.hpp"

struct msghdr;

namespace hal {

// What the socket itself saw since open(). What the bus did arrives as error frames.
struct SocketCanCounters {
  uint64_t sent = 0;
  uint64_t received = 0;          // data frames
  uint64_t error_frames = 0;      // received ones
  uint64_t queue_full = 0;        // refused by a full transmit queue (ENOBUFS)
  uint64_t interface_down = 0;    // times the interface went away
  uint32_t receive_overflow = 0;  // frames that the kernel dropped because this program read too late
  uint64_t faults = 0;            // any other refusal
};

class SocketCan final : public CanBus {
 public:
  static constexpr size_t kMaxFilters = 64;
  static constexpr uint32_t kNoId = UINT32_MAX;
  struct Options {
    bool fd = false;           // send and receive CAN FD frames too
    bool error_frames = true;  // deliver the bus's error frames
    bool data_frames = true;   // false: error frames and the filters' ids only
    int receive_buffer_bytes = 1 << 20;
    // Frames of this 11-bit identifier count as sent when the bus has carried those before them (frames_in_flight.hpp): the drive's.
    uint32_t confirmed_id = kNoId;
  };

  // Empty where it worked; else what is wrong and what to do about it.
  std::string open(const std::string& interface, const Options& options);
  // Receive these 11-bit identifiers alone, from the next open() on; id_count 0: all.
  bool receive_only(const uint32_t* ids, size_t id_count);

  CanResult send(const CanFrame& frame) override;
  CanResult receive(CanFrame& frame) override;
  uint32_t receive_overflows() const override { return overflow_before_ + counters_.receive_overflow; }

  int descriptor() const { return socket_.get(); }  // to wait on; changes when the interface was removed and came back
  const SocketCanCounters& counters() const { return counters_; }

 private:
  int connect();  // 0 or errno
  bool configure(int socket);
  bool confirms() const { return options_.confirmed_id != kNoId; }
  CanResult refused(int error);
  void reopen_if_due();
  CanResult receive_any(CanFrame& frame, bool& own);  // own: one that this socket has sent
  void note_in_flight(const CanFrame& frame, bool from_this_machine);
  uint64_t read_control(const msghdr& message);

  char interface_[16] = {};
  Options options_;
  can_filter filters_[kMaxFilters + 1] = {};  // and the confirmed identifier
  size_t filter_count_ = 0;
  FileDescriptor socket_;
  bool up_ = false;
  bool lost_ = false;  // the interface was removed: the socket must be made anew
  uint64_t next_try_ns_ = 0;
  FramesInFlight in_flight_;      // of the confirmed identifier
  uint32_t overflow_before_ = 0;  // of sockets before this one: the kernel counts anew for each
  SocketCanCounters counters_;
};

}  // namespace hal
