// Puts a page in its place all at once.
#include <filesystem>

#include "host_sim/records/output_file.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

void write_index(const std::string& directory, const std::string& content) {
  std::error_code failure;
  const bool made = std::filesystem::create_directories(directory, failure);
  if (failure || !std::filesystem::is_directory(directory))
    throw OutputError(directory + ": expected a folder for the report, or a place to make one" +
                      (failure ? " (" + failure.message() + ")" : std::string()));
  try {
    write_output_file((std::filesystem::path(directory) / "index.html").string(), content);
  } catch (const OutputError&) {
    if (made) std::filesystem::remove(directory, failure);
    throw;
  }
}

}  // namespace host_sim::reports
