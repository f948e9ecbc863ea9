// The rows' answer, where free runs bear it out.
#pragma once
#include "../first_screen/rows_say.hpp"
#include "answer.hpp"

namespace diagnosis::runs {

// Asks the rows. True where nothing is left beyond their noise and runs that have not seen the data bear out all that they
// name: `d` is then the answer, scored and with the wider intervals of the runs. Otherwise what they found out stays in `say`
// and `choice`, and d.rejected has what was not borne out.
bool answered_by_rows(const Asked& asked, const Task& task, std::vector<Prepared>& records, Choice& choice,
                      RowsSay& say, Diagnosis& d);

// Faults of motion channels that the runs bear out are taken before they look for anything else.
void adopt_faults(const Task& task, const std::vector<SensorFault>& faults, Choice& choice);

}  // namespace diagnosis::runs
