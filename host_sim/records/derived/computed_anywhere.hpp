// Columns that were computed from others in some of the records: no two records may have other channels.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

struct LeftOutToo {
  std::string file, note;
};

// A column that was left out of one record (Record::computed) is left out of the others: what is too short to tell, or has no noise to
// tell it by, is of the same origin under the same name. It stays where its DOF has no other motion. Returns what to say of it.
std::vector<LeftOutToo> leave_out_computed_anywhere(const std::vector<std::vector<Record>*>& all);

}  // namespace host_sim
