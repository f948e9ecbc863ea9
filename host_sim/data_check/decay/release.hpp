// What records of free decays hold beside them: a hand that leads the rig, a pull that is held, blows that nobody measured.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Tells of them and of what was dropped beside them, where they are not the whole record.
std::optional<Finding> find_release(const Record& record);

// Takes all else off the records: each decay becomes a record, eight at most where a file holds several. One sentence for each
// record that loses any.
std::vector<std::string> keep_decays(std::vector<Record>& records);

}  // namespace host_sim::data_check
