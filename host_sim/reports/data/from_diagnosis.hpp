// What `host_sim diagnose` finds, as the data of its report.
#pragma once
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// Everything but the pictures.
DiagnosisReportData findings_of(const rig_file::RigModel& rig, const std::vector<Record>& training,
                                const std::vector<Record>& holdout, const diagnosis::Diagnosis& found);

// Simulates both rigs for the pictures. They show the hold-out record that the rig as given misses most, or, where there is none,
// such a record of the training (which the fit has seen: the parameters come from all of it).
void add_pictures(const rig_file::RigModel& rig, const std::vector<Record>& training,
                  const std::vector<Record>& holdout, const diagnosis::Diagnosis& found, DiagnosisReportData& data);

// The rig with every unknown replaced: by the parameter of its name, else by the start value that the rig carries.
rig_file::RigModel with_parameters(const rig_file::RigModel& rig, const std::vector<diagnosis::Parameter>& parameters);

}  // namespace host_sim::reports
