#include "host_sim/programs/run/record_export.hpp"

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

}  // namespace

void export_records(const std::string& folder, const Scenario& scenario, const RunResult& run) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    throw OutputError(folder + ": cannot be made (" + fault.message() + "), expected a folder that takes files");
  write_output_file(folder + "/rig.toml", rig_file::format_rig(scenario.rig));
  for (size_t i = 0; i < scenario.levels.size(); ++i)
    write_output_file(folder + "/level_" + std::to_string(i + 1) + ".csv",
                      format_csv(without_settling(run.measured.measured[i], scenario.levels[i])));
}

}  // namespace host_sim
