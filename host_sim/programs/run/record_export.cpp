#include "host_sim/programs/run/record_export.hpp"

#include <algorithm>
#include <filesystem>

#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/records/csv/csv_writer.hpp"
#include "host_sim/records/files/output_file.hpp"

namespace host_sim {
namespace {

Record without_settling(Record record, const ExcitationLevel& level) {
  const auto settling = static_cast<std::ptrdiff_t>(level.settle_samples);
  for (Channel& channel : record.channels)
    channel.values.erase(channel.values.begin(), channel.values.begin() + settling);
  record.start_s = 0.0;
  return record;
}

std::string level_file(size_t number) { return "level_" + std::to_string(number) + ".csv"; }

}  // namespace

std::vector<std::string> levels_of_others(const std::string& folder, size_t levels) {
  std::vector<std::string> names;
  std::error_code fault;
  for (const auto& entry : std::filesystem::directory_iterator(folder, fault)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("level_", 0) != 0 || entry.path().extension() != ".csv") continue;
    bool own = false;
    for (size_t i = 1; i <= levels; ++i) own = own || name == level_file(i);
    if (!own) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

void export_records(const std::string& folder, const Scenario& scenario, const RunResult& run) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    throw OutputError(folder + ": cannot be made (" + fault.message() + "), expected a folder that takes files");
  write_output_file(folder + "/rig.toml", rig_file::format_rig(scenario.rig));
  for (size_t i = 0; i < scenario.levels.size(); ++i)
    write_output_file(folder + "/" + level_file(i + 1),
                      format_csv(without_settling(run.measured.measured[i], scenario.levels[i])));
}

}  // namespace host_sim
