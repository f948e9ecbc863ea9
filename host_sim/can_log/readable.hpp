// Numbers and states as a person reads them.
#pragma once
#include <cstdint>
#include <string>

#include "firmware/can_protocol/frame_description.hpp"
#include "hal/interface/can_bus.hpp"

namespace can_log {

std::string number_text(double value, int digits);  // "20.00123", "1.25e-05"
// "20.0041" for a half-width of 0.0003: two digits of the uncertainty, 3 to 9 significant digits in all.
std::string rounded_to(double value, double uncertainty);
// mantissa * 10^exponent, rounded once: a power of ten up to 10^22 is exact.
double times_power_of_ten(double mantissa, int exponent);
float float_of_bits(int64_t bits);                   // IEEE 754 single precision
std::string hex_text(uint64_t value, int digits);    // "0x0A"
std::string bytes_text(const hal::CanFrame& frame);  // "11 22 33"

// Empty where the value has no name.
std::string state_name(const firmware::can::ValueTable& names, int64_t raw);
// "SENSOR_LOST | DRIVE_LIMIT", "none"; bits without a name by their number.
std::string flag_names(const firmware::can::ValueTable& names, int64_t raw);
// "INTEGRATE", "none", "12.5 %", "300 samples".
std::string signal_text(const firmware::can::Signal& signal, int64_t raw);
// "bus-off", "controller problem (receive overflow), restarted": what a SocketCAN error frame says.
std::string error_frame_text(const hal::CanFrame& frame);

}  // namespace can_log
