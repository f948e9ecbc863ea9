// What every page shows of a rig with numbers: modes, responses, force-state maps, residual spectra.
#pragma once
#include <string>
#include <vector>

namespace host_sim::reports {

// One value with its 95 % interval; NaN where there is none.
struct Interval {
  double value, low, high;
};

// Motion per force over frequency, measured and simulated by the same averages. Vectors of one length; `simulated`
// is empty where there is no simulation.
struct ResponseView {
  std::string title;                                                 // "acceleration of DOF 2 per force on DOF 1"
  std::string label, unit;                                           // "acceleration per force", "m/s^2/N"
  std::vector<double> frequency_Hz, measured, simulated, coherence;  // magnitudes; coherence 0 to 1
  size_t segments = 0;                                               // averaged
};

// A mode of the estimated rig's linear part.
struct ModeRow {
  Interval frequency_Hz, damping_ratio;
  std::vector<double> shape;  // per DOF, the largest 1; negative: against it
};

// Restoring force of a link over elongation and rate: mean of the samples in each cell, measured and by the model.
struct ForceStateMap {
  std::string link, force_unit = "N", elongation_unit = "m", rate_unit = "m/s";
  size_t columns = 0, rows = 0;  // of cells: elongation across, rate upwards
  double elongation_low = 0.0, elongation_high = 0.0, rate_low = 0.0, rate_high = 0.0;
  std::vector<double> measured, model;  // row by row from below; NaN where no sample was
};

// What of the force no term explains, over frequency, beside the force that drives or accelerates the DOF.
struct ResidualSpectrum {
  int dof = 1;
  std::string unit = "N";
  std::vector<double> frequency_Hz, residual, reference;  // power densities, unit^2 / Hz
};

// What every page shows of a rig with numbers: filled by data/rig_views.
struct RigViews {
  std::vector<ResponseView> responses;
  std::vector<ModeRow> modes;
  std::vector<ForceStateMap> maps;
  std::vector<ResidualSpectrum> residuals;
  std::string one_record;  // "level_1.csv, the first of 3 records": what maps and residuals are of; empty: there is one
  std::vector<std::string> notes;  // what these sensors cannot show, and why
  bool of_extended_rig = false;    // the simulated curves are those of the extended rig
};

}  // namespace host_sim::reports
