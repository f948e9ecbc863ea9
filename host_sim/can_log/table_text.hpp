// The numbers of the frame table as text, for the DBC and the protocol page.
#pragma once
#include <string>

#include "firmware/can_protocol/frame_description.hpp"

namespace can_log {

double factor(const firmware::can::Signal& signal);
double physical(const firmware::can::Signal& signal, int64_t raw);
std::string shortest(double value);  // the fewest digits that read back as the same number
std::string lower_case(std::string text);

}  // namespace can_log
