// What the page of a diagnosis says of the records.
#pragma once
#include <string>
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::reports {

// "20 s", "2 records of 20 s each", "2 records of 35 s in all".
std::string lengths_text(const std::vector<Record>& records);
// Which record does not go with the others; empty where all do.
std::string odd_record_text(const diagnosis::Diagnosis& found);

}  // namespace host_sim::reports
