// An SDO request or answer in words: "read device_name (1008.0)", "heartbeat_time (1017.0) = 500".
#pragma once
#include <string>

#include "firmware/can_protocol/can_frame.hpp"

namespace can_log {

std::string sdo_request_text(const firmware::CanFrame& message);
std::string sdo_reply_text(const firmware::CanFrame& message);

}  // namespace can_log
