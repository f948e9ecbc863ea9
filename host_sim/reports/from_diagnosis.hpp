// What `host_sim diagnose` finds, as the data of its report.
#pragma once
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/reports/report_data.hpp"

namespace host_sim::reports {

// The pictures show the first hold-out record, or, where there is none, the first record, whose last holdout_fraction
// the fit has not seen.
DiagnosisReportData diagnosis_report_data(const rig_file::RigModel& rig, const std::vector<Record>& training,
                                          const std::vector<Record>& holdout, const diagnosis::Diagnosis& found,
                                          double holdout_fraction);

// The rig with every unknown replaced: by the parameter of its name, else by the start value that the rig carries.
rig_file::RigModel with_parameters(const rig_file::RigModel& rig, const std::vector<diagnosis::Parameter>& parameters);

}  // namespace host_sim::reports
