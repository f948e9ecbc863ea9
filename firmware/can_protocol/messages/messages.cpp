#include "firmware/can_protocol/messages/messages.hpp"

#include "firmware/can_protocol/values/decimal.hpp"

namespace firmware {

NodeStatus node_status(const Estimates* estimates, ControllerMode mode, uint16_t faults) {
  NodeStatus status;
  status.faults = faults;
  status.mode = mode;
  if (estimates == nullptr) return status;
  status.update_counter = estimates->window_counter;
  if (!estimates->condition_number.is_zero()) {
    const int32_t log2 = log2_floor(estimates->condition_number);
    status.condition_log2 = static_cast<uint8_t>(log2 < 0 ? 0 : log2 > 255 ? 255 : log2);
  }
  if (estimates->unknown_count > 0) status.quality = EstimateStatus::kValid;
  for (int i = 0; i < estimates->unknown_count; ++i)
    if (severity(estimates->parameters[i].status) > severity(status.quality))
      status.quality = estimates->parameters[i].status;
  return status;
}

WindowResult window_result(const Estimates& estimates) {
  WindowResult result;
  result.residual_e9 = static_cast<uint32_t>(decimal_mantissa(abs(estimates.residual_mean_abs), -9, 0xFFFFFFFFll));
  result.equations = estimates.rows;
  result.window = estimates.window_counter;
  return result;
}

}  // namespace firmware
