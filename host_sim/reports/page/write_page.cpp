// Puts a page in its place all at once, and the data of its pictures beside it.
#include <filesystem>
#include <set>

#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/figures/figure_csv.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {
namespace {

namespace fs = std::filesystem;

// Those of an earlier page that this page has not.
void remove_earlier(const fs::path& folder, const std::set<std::string>& written) {
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const std::string name = entry.path().filename().string();
    if (is_figure_file_name(name) && written.count(name) == 0) fs::remove(entry.path(), failure);
  }
}

void write_figures(const fs::path& folder, const std::vector<Plot>& plots) {
  if (plots.empty()) return;
  std::error_code failure;
  fs::create_directory(folder, failure);
  if (failure) throw OutputError(folder.string() + ": cannot be made (" + failure.message() + ")");
  std::set<std::string> written;
  for (size_t i = 0; i < plots.size(); ++i) {
    const std::string name = figure_file_name(i + 1, plots[i]);
    write_output_file((folder / name).string(), figure_csv(plots[i]));
    written.insert(name);
  }
  remove_earlier(folder, written);
}

}  // namespace

void write_page(const std::string& directory, const Page& page) {
  std::error_code failure;
  const bool made = fs::create_directories(directory, failure);
  if (failure || !fs::is_directory(directory))
    throw OutputError(directory + ": expected a folder for the report, or a place to make one" +
                      (failure ? " (" + failure.message() + ")" : std::string()));
  try {
    write_output_file((fs::path(directory) / "index.html").string(), page.finish());
  } catch (const OutputError&) {
    if (made) fs::remove(directory, failure);
    throw;
  }
  write_figures(fs::path(directory) / "figures", page.plots());
}

}  // namespace host_sim::reports
