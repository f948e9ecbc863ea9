// Frames that the bus would not take yet. Sent in the order of their identifiers, as the bus itself would arbitrate;
// among equal identifiers the newest replaces the older one where it says the same thing later (push()); emergencies, answers to
// requests and what is told once are all kept. Nothing blocks: when there is no room the least urgent frame is given up, and every frame that never goes out is counted.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/can_frame.hpp"
#include "firmware/can_protocol/frame_description.hpp"
#include "firmware/configuration/capacity.hpp"
#include "hal/interface/can_bus.hpp"

namespace firmware {

class TransmitQueue {
 public:
  static constexpr int kCapacity = 96;
  static constexpr uint32_t kNoId = UINT32_MAX;

  TransmitQueue();
  // replace: a queued frame with the same identifier is superseded. A frame with more data than fit is given up.
  void push(const CanFrame& message, bool replace = true);
  // Sends until the bus refuses (a frame that the driver cannot send at all is given up) or nothing is left. Returns
  // the last answer of the bus; kEmpty: nothing was waiting.
  hal::CanResult flush(hal::CanBus& bus);

  // All that wait of a kind: what they say has been forgotten.
  void give_up(const can::IdPlan& ids, int node);

  // Frames of this identifier are reported when the bus has taken one: true once for each flush that sent any.
  void watch(uint32_t id) { watched_id_ = id; }
  bool take_watched_sent();

  bool has(uint32_t id) const { return rank_of(id) < count_; }
  // A byte of the first waiting frame of this identifier; -1: there is none.
  int byte_of(uint32_t id, int number) const;
  int waiting() const { return count_; }
  int room() const { return kCapacity - count_; }
  bool has_room_for_more() const { return 2 * room() > kCapacity; }  // for what is not urgent
  uint32_t given_up() const { return given_up_; }
  uint32_t sent() const { return sent_; }

 private:
  static constexpr int kMostData = kSendsFd ? 64 : 8;
  struct Waiting {  // what is sent of a CanFrame
    uint32_t id;
    uint32_t pushed_at;  // flushes_ when it came: superseded before the bus has refused it, it is no loss
    bool extended : 1, remote : 1, error : 1, fd : 1;
    uint8_t flags, length;
    uint8_t data[kMostData];
  };
  Waiting& waiting_at(int rank) { return waiting_[order_[rank]]; }
  int rank_of(uint32_t id) const;
  void put(Waiting& place, const CanFrame& message) const;
  static CanFrame frame_of(const Waiting& place);
  void remove(int rank);

  Waiting waiting_[kCapacity] = {};
  // the first count_: places in waiting_ by identifier, oldest first among equals; then the free places
  uint8_t order_[kCapacity];
  int count_ = 0;
  uint32_t flushes_ = 0;
  uint32_t watched_id_ = kNoId;
  bool watched_sent_ = false;
  uint32_t given_up_ = 0;
  uint32_t sent_ = 0;
};

}  // namespace firmware
