#include "host_sim/programs/estimate/ac_coupled.hpp"

#include <fmt/format.h>

#include <map>

#include "host_sim/data_check/drive/excitation.hpp"
#include "host_sim/data_check/one_motion/coupling.hpp"
#include "host_sim/records/ac_coupling.hpp"

namespace host_sim {

std::vector<std::string> undo_shown_ac_couplings(SharedRecords& records) {
  std::map<std::string, std::vector<double>> corners_Hz;
  for (const Record& record : records.get()) {
    const std::vector<double> lines_Hz = data_check::drive_of(record).lines_Hz;
    for (const data_check::Finding& found :
         data_check::find_ac_coupling(record, nullptr, lines_Hz.empty() ? 0.0 : lines_Hz.back()))
      if (found.value) corners_Hz[found.channel].push_back(*found.value);
  }
  std::vector<AcCoupling> couplings;
  std::vector<std::string> notes;
  for (const auto& [channel, corners] : corners_Hz) {
    if (2 * corners.size() < records.get().size()) continue;
    double sum_Hz = 0.0;
    for (const double corner_Hz : corners) sum_Hz += corner_Hz;
    const double mean_Hz = sum_Hz / static_cast<double>(corners.size());
    couplings.push_back({channel, mean_Hz});
    notes.push_back(
        fmt::format("{} has passed a high-pass of {:.3g} Hz, as the other channels of its DOF tell: undone; "
                    "ac_coupling_Hz = {:.3g} in the rig file's [[channel]] of that name says so for good",
                    channel, mean_Hz, mean_Hz));
  }
  if (!couplings.empty()) undo_ac_coupling(couplings, records.own());
  return notes;
}

}  // namespace host_sim
