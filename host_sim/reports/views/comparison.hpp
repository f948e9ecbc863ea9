// A record beside what two rigs make of it: the pictures' data of the diagnosis page.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

struct Comparison {
  std::vector<DofView> dofs;
  std::vector<LinkView> links;
  std::vector<std::string> notes;  // what a reader must know of how it was made
  bool free = false;               // simulated freely; else by the force that the rig needs
};

// One of the two rigs: every coefficient a number. simulated: the record run freely from its own initial state, where
// that has been done already; else it is done here.
struct Side {
  const rig_file::RigModel& rig;
  const Record* simulated = nullptr;
};

// The free-running simulations start from a fitted state (fitted_start.hpp) at the record's start, and at every second where nothing
// holds a DOF in its place (there any error of the state grows for ever). A rig that cannot run freely (a DOF without
// mass) is compared by the force that it would need for the measured motion.
Comparison compare(const Record& record, const Side& given);
// With an extended rig beside it, whose first links are those of the rig as given.
Comparison compare(const Record& record, const Side& given, const Side& extended);

}  // namespace host_sim::reports
