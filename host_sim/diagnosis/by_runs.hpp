// What free runs say where the rows of the equations do not have the last word.
#pragma once
#include "choice/choice.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// By free runs, from the rig as given with the sensor faults that they bear out. Numbers of the rig file that may be wrong may
// stand for something else: they are the answer where causes beside the rig as given leave more than noise, and simulate
// unseen data worse.
void answer_by_runs(const Asked& asked, const runs::Task& task, const RowsSay& say, const runs::Choice* numbers,
                    runs::Choice& choice);

// What the free runs lose in noise and the rows see beside nothing else is there.
bool trace_is_there(const runs::Task& task, const RowsSay& say, const runs::Choice& choice);

// What free runs say, with numbers beside rounded jumps; also where causes were taken back that may have stood for them.
void answer_beside_rounded_jumps(const runs::Task& task, std::vector<runs::Prepared>& records, runs::Choice& choice,
                                 Diagnosis& d);

}  // namespace diagnosis
