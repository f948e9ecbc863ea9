#include "firmware/rig_controller/bus/window_frames.hpp"

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"

namespace firmware {

void WindowFrames::forget() {
  estimates_ = nullptr;
  judged_ = false;
  next_float_ = floats_ = 0;
  const can::FrameDescription* const told[] = {&can::kWindow,        &can::kEstimate,        &can::kEstimateFd,
                                               &can::kEstimateFloat, &can::kEstimateFloatFd, &can::kDiagnosis,
                                               &can::kDiagnosisSize, &can::kDiagnosisRival};
  for (const can::FrameDescription* frame : told) queue_.give_up(frame->ids, configuration_.node.node);
}

void WindowFrames::send(const Estimates& estimates, bool judged) {
  const NodeConfiguration& node = configuration_.node;
  estimates_ = &estimates;
  queue_.push(pack_window(node.node, window_result(estimates)));
  next_float_ = 0;
  floats_ = !sends_float_estimates(configuration_) ? 0
            : node.can_fd                          ? fd_frames(estimates.unknown_count)
                                                   : estimates.unknown_count;
  if (node.can_fd) {
    for (int i = 0; i < fd_frames(estimates.unknown_count); ++i)
      queue_.push(pack_estimates_fd(node.node, i, estimates));
  } else {
    for (int i = 0; i < estimates.unknown_count; ++i)
      queue_.push(pack_estimate(node.node, i, estimates.parameters[i], estimates.window_counter));
  }
  if (judged) judge(estimates);
}

// Told at once where it has changed.
void WindowFrames::judge(const Estimates& estimates) {
  const bool tested = estimates.warrant.tested;
  const Diagnosis judgement = diagnosis_of(estimates);
  const bool changed = judgement.cause != diagnosis_.cause || judgement.place_a != diagnosis_.place_a ||
                       judgement.place_b != diagnosis_.place_b || judgement.quantity != diagnosis_.quantity ||
                       judgement.corrected != diagnosis_.corrected;
  const bool told = tested && (changed || !judged_);
  judged_ = tested;
  if (tested) diagnosis_ = judgement;
  if (told) send_diagnosis();
}

void WindowFrames::repeat_diagnosis() {
  if (judged_) send_diagnosis();
}

void WindowFrames::send_diagnosis() {
  const uint8_t node = configuration_.node.node;
  queue_.push(pack_diagnosis(node, diagnosis_));
  if (diagnosis_.cause == Cause::kNone) return;
  queue_.push(pack_diagnosis_size(node, diagnosis_));
  queue_.push(pack_diagnosis_rival(node, diagnosis_));
}

void WindowFrames::send_some_floats() {
  const NodeConfiguration& node = configuration_.node;
  for (; next_float_ < floats_ && queue_.has_room_for_more(); ++next_float_)
    queue_.push(node.can_fd ? pack_estimates_float_fd(node.node, next_float_, *estimates_)
                            : pack_estimate_float(node.node, next_float_, estimates_->parameters[next_float_]));
}

}  // namespace firmware
