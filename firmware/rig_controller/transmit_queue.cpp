// See transmit_queue.hpp.
#include "firmware/rig_controller/transmit_queue.hpp"

namespace firmware {
TransmitQueue::TransmitQueue() {
  for (int i = 0; i < kCapacity; ++i) order_[i] = static_cast<uint8_t>(i);
}

void TransmitQueue::push(const CanFrame& message, bool replace) {
  if (replace) {
    for (int rank = 0; rank < count_; ++rank) {
      if (waiting_at(rank).id != message.id) continue;
      uint32_t& pushed_at = pushed_at_[order_[rank]];
      waiting_at(rank) = message;
      given_up_ += pushed_at == flushes_ ? 0 : 1;
      pushed_at = flushes_;
      return;
    }
  }
  if (count_ == kCapacity) {
    ++given_up_;
    if (waiting_at(count_ - 1).id <= message.id) return;
    --count_;
  }
  const uint8_t place = order_[count_];
  frames_[place] = message;
  pushed_at_[place] = flushes_;
  int rank = count_++;
  for (; rank > 0 && waiting_at(rank - 1).id > message.id; --rank) order_[rank] = order_[rank - 1];
  order_[rank] = place;
}

void TransmitQueue::remove_first() {
  const uint8_t freed = order_[0];
  --count_;
  for (int rank = 0; rank < count_; ++rank) order_[rank] = order_[rank + 1];
  order_[count_] = freed;
}

hal::CanResult TransmitQueue::flush(hal::CanBus& bus) {
  hal::CanResult result = hal::CanResult::kEmpty;
  ++flushes_;
  while (count_ > 0) {
    result = bus.send(waiting_at(0));
    if (result == hal::CanResult::kDone) {
      ++sent_;
      watched_sent_ = watched_sent_ || waiting_at(0).id == watched_id_;
    } else if (result == hal::CanResult::kFault) {
      ++given_up_;  // kept, it would block all others
    } else {
      break;
    }
    remove_first();
  }
  return result;
}

bool TransmitQueue::take_watched_sent() {
  const bool sent = watched_sent_;
  watched_sent_ = false;
  return sent;
}

const CanFrame* TransmitQueue::find(uint32_t id) const {
  for (int rank = 0; rank < count_; ++rank)
    if (frames_[order_[rank]].id == id) return &frames_[order_[rank]];
  return nullptr;
}

}  // namespace firmware
