// What the rows of the equations of motion say: the diagnosis's first screen.
#pragma once
#include "../diagnosis.hpp"
#include "../sensors/sensor_check.hpp"
#include "../terms/terms.hpp"
#include "remainder.hpp"

namespace diagnosis {

// What diagnose() was asked.
struct Asked {
  const rig_file::RigModel& rig;
  const std::vector<host_sim::Record>& training;
  const std::vector<host_sim::Record>& holdout;
  const Options& options;
  bool ground_known = true;  // false: motion counts from a base that runs on
};

// A term with its coefficient.
struct Valued {
  Term term;
  double value = 0;
};

// What the equations' rows say, weighted by noise: right where their assumptions hold (a force, masses that are known, noise
// that is white or first order), and fast. noise_only: they do hold as far as what is left can tell.
struct RowsSay {
  Diagnosis d;
  bool asked = false;
  Remainder left;  // beside what it names
  std::vector<SensorFault>
      faults;               // of motion channels, already taken out; of a DOF's only channel where noise is left
  std::vector<Term> terms;  // that it names beside the rig's own
  std::vector<double> values;
  std::vector<Valued> model;  // with them, beside the rig's own
};

// Throws CannotAnswer where the records make too few rows.
RowsSay ask_rows(const System& system, const Asked& asked);

// Faults of motion channels that a second channel of the same DOF bears out; none where a record is too short to tell.
std::vector<SensorFault> motion_faults(const Asked& asked);

}  // namespace diagnosis
