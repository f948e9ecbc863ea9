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
};

// given, extended: every coefficient a number; extended has the links of given first. The free-running simulations
// start from the measured state at the record's start and again at sample holdout_from (0: no such part), and at every
// second where nothing holds a DOF in its place (there any error of the state grows for ever). A rig that cannot run
// freely (a DOF without mass) is compared by the force that it would need for the measured motion.
Comparison compare(const Record& record, const rig_file::RigModel& given, const rig_file::RigModel& extended);

}  // namespace host_sim::reports
