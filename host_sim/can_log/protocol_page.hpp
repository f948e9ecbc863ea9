// The tables of docs/can_protocol.md, from the frame table. In the page they stand between two marker lines; what is
// around them is written by hand.
#pragma once
#include <ostream>
#include <string>

namespace can_log {

extern const char* const kGeneratedBegin;  // marker lines
extern const char* const kGeneratedEnd;

void protocol_tables(std::ostream& output);
// The page with its generated part renewed; empty where the markers are missing or in the wrong order.
std::string renewed_page(const std::string& page);

}  // namespace can_log
