// What the core says of drawn records, by the way that `host_sim estimate` takes.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace coverage {

struct Answer {
  firmware::Estimates estimates;
  std::vector<std::string> names;  // of the unknowns
};

Answer answer_to(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records);

}  // namespace coverage
