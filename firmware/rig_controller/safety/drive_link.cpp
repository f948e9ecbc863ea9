// See drive_link.hpp.
#include "firmware/rig_controller/safety/drive_link.hpp"

#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {

void DriveLink::configure(uint8_t node, bool on_can, Drive step_per_sample) {
  node_ = node;
  on_can_ = on_can;
  step_per_sample_ = step_per_sample;
  frame_id_ = can::frame_id(can::kDrive.ids, node);
  if (on_can) queue_.watch(frame_id_);
}

Drive DriveLink::reachable(Drive wanted) const {
  if (wanted == Drive{}) return wanted;
  const int64_t change = static_cast<int64_t>(wanted.raw) - delivered_command_.raw;
  return Drive::from_raw(static_cast<int32_t>(delivered_command_.raw + clamp_magnitude(change, step_per_sample_.raw)));
}

bool DriveLink::command(Drive drive, uint32_t sequence, uint64_t now_ns) {
  commanded_ = drive;
  taken_ = output_.write(drive.raw);
  if (on_can_) send(sequence, DriveState::kEnabled, now_ns);
  if (delivered()) delivered_command_ = commanded_;
  return taken_;
}

bool DriveLink::stop(uint64_t now_ns) {
  commanded_ = Drive{};
  taken_ = output_.write(0);
  const CanFrame stopped = pack_drive(node_, {0, 0, DriveState::kStopped});
  const bool waits_already = on_can_ && queue_.byte_of(frame_id_, 6) == stopped.data[6];
  if (on_can_ && !waits_already) send(0, DriveState::kStopped, now_ns);
  if (delivered()) delivered_command_ = commanded_;
  return taken_;
}

void DriveLink::send(uint32_t sequence, DriveState state, uint64_t now_ns) {
  queue_.push(pack_drive(node_, {commanded_.raw, sequence, state}));
  if (!frame_waits_) waits_since_ns_ = now_ns;
  frame_waits_ = true;
}

void DriveLink::note_sent() {
  if (!frame_waits_ || !queue_.take_watched_sent()) return;
  frame_waits_ = false;
  if (delivered()) delivered_command_ = commanded_;
}

}  // namespace firmware
