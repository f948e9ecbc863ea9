// See transmit_queue.hpp.
#include "firmware/rig_controller/bus/transmit_queue.hpp"

namespace firmware {
namespace {

// What is sent of a frame.
template <typename From, typename To>
void copy(const From& from, To& to) {
  to.id = from.id;
  to.extended = from.extended;
  to.remote = from.remote;
  to.error = from.error;
  to.fd = from.fd;
  to.flags = from.flags;
  to.length = from.length;
  for (int i = 0; i < from.length; ++i) to.data[i] = from.data[i];
}

bool is_of(const can::IdPlan& ids, int node, uint32_t id) {
  for (int first = 0; first < ids.members; first += ids.bank_members) {
    const int left = ids.members - first, members = left < ids.bank_members ? left : ids.bank_members;
    if (id - can::frame_id(ids, node, first) < static_cast<uint32_t>(members)) return true;
  }
  return false;
}

}  // namespace

TransmitQueue::TransmitQueue() {
  for (int i = 0; i < kCapacity; ++i) order_[i] = static_cast<uint8_t>(i);
}

void TransmitQueue::put(Waiting& place, const CanFrame& message) const {
  copy(message, place);
  place.pushed_at = flushes_;
}

CanFrame TransmitQueue::frame_of(const Waiting& place) {
  CanFrame message;
  copy(place, message);
  return message;
}

int TransmitQueue::rank_of(uint32_t id) const {
  int rank = 0;
  while (rank < count_ && waiting_[order_[rank]].id != id) ++rank;
  return rank;
}

void TransmitQueue::push(const CanFrame& message, bool replace) {
  if (message.length > kMostData) {
    ++given_up_;
    return;
  }
  const int same = replace ? rank_of(message.id) : count_;
  if (same < count_) {
    given_up_ += waiting_at(same).pushed_at == flushes_ ? 0 : 1;
    return put(waiting_at(same), message);
  }
  if (count_ == kCapacity) {
    ++given_up_;
    if (waiting_at(count_ - 1).id <= message.id) return;
    --count_;
  }
  const uint8_t place = order_[count_];
  put(waiting_[place], message);
  int rank = count_++;
  for (; rank > 0 && waiting_at(rank - 1).id > message.id; --rank) order_[rank] = order_[rank - 1];
  order_[rank] = place;
}

void TransmitQueue::remove(int rank) {
  const uint8_t freed = order_[rank];
  --count_;
  for (; rank < count_; ++rank) order_[rank] = order_[rank + 1];
  order_[count_] = freed;
}

void TransmitQueue::give_up(const can::IdPlan& ids, int node) {
  for (int rank = count_ - 1; rank >= 0; --rank) {
    if (!is_of(ids, node, waiting_at(rank).id)) continue;
    remove(rank);
    ++given_up_;
  }
}

hal::CanResult TransmitQueue::flush(hal::CanBus& bus) {
  hal::CanResult result = hal::CanResult::kEmpty;
  ++flushes_;
  while (count_ > 0) {
    result = bus.send(frame_of(waiting_at(0)));
    if (result == hal::CanResult::kDone) {
      ++sent_;
      watched_sent_ = watched_sent_ || waiting_at(0).id == watched_id_;
    } else if (result == hal::CanResult::kFault) {
      ++given_up_;  // kept, it would block all others
    } else {
      break;
    }
    remove(0);
  }
  return result;
}

bool TransmitQueue::take_watched_sent() {
  const bool sent = watched_sent_;
  watched_sent_ = false;
  return sent;
}

int TransmitQueue::byte_of(uint32_t id, int number) const {
  const int rank = rank_of(id);
  return rank < count_ ? waiting_[order_[rank]].data[number] : -1;
}

}  // namespace firmware
