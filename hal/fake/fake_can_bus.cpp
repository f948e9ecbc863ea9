// See fake_can_bus.hpp. Error classes and data bytes follow linux/can/error.h.
#include "hal/fake/fake_can_bus.hpp"

namespace hal {
namespace {

constexpr uint32_t kClassController = 0x004;
constexpr uint32_t kClassNoAcknowledge = 0x020;
constexpr uint32_t kClassBusOff = 0x040;
constexpr uint32_t kClassRestarted = 0x100;
constexpr size_t kQueueLength = 3;

}  // namespace

CanFrame make_error_frame(ErrorFrame kind) {
  CanFrame frame;
  frame.error = true;
  frame.length = 8;
  frame.id = kClassController;
  switch (kind) {
    case ErrorFrame::kBusOff:
      frame.id = kClassBusOff;
      break;
    case ErrorFrame::kRestarted:
      frame.id = kClassRestarted;
      break;
    case ErrorFrame::kNoAcknowledge:
      frame.id = kClassNoAcknowledge;
      break;
    case ErrorFrame::kErrorPassive:
      frame.data[1] = 0x20;
      break;
    case ErrorFrame::kErrorActive:
      frame.data[1] = 0x40;
      break;
    case ErrorFrame::kReceiveOverflow:
      frame.data[1] = 0x01;
      break;
  }
  return frame;
}

CanResult FakeCanBus::send(const CanFrame& frame) {
  switch (failure_) {
    case BusFailure::kQueueFull:
      return CanResult::kQueueFull;
    case BusFailure::kDown:
      return CanResult::kBusDown;
    case BusFailure::kDriverFault:
      return CanResult::kFault;
    case BusFailure::kShortQueue:
      if (queued_ >= kQueueLength) return CanResult::kQueueFull;
      ++queued_;
      break;
    case BusFailure::kNone:
      break;
  }
  ++sent_count_;
  if (keep_) {
    sent_.push_back(frame);
    sent_.back().time_ns = clock_.now_ns();
  }
  return CanResult::kDone;
}

CanResult FakeCanBus::receive(CanFrame& frame) {
  if (failure_ == BusFailure::kDown) return CanResult::kBusDown;
  if (incoming_.empty()) return CanResult::kEmpty;
  frame = incoming_.front();
  incoming_.pop_front();
  return CanResult::kDone;
}

size_t FakeCanBus::count(uint32_t id) const {
  size_t found = 0;
  for (const CanFrame& frame : sent_) found += frame.id == id ? 1 : 0;
  return found;
}

const CanFrame* FakeCanBus::last(uint32_t id) const {
  for (auto frame = sent_.rbegin(); frame != sent_.rend(); ++frame)
    if (frame->id == id) return &*frame;
  return nullptr;
}

}  // namespace hal
