// Puts a page in its place all at once, and the data of its pictures beside it.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/figures/figure_csv.hpp"
#include "host_sim/reports/page/page.hpp"
#include "host_sim/reports/page/report.hpp"

namespace host_sim::reports {
namespace {

namespace fs = std::filesystem;

// The names of the pictures' files that an earlier page in the folder has.
std::set<std::string> earlier_figures(const std::string& directory) {
  std::ostringstream page;
  page << std::ifstream(fs::path(directory) / "index.html", std::ios::binary).rdbuf();
  return figures_of_page(page.str());
}

// In place of those of the earlier page. What else stands there is the user's.
void write_figures(const fs::path& folder, const std::vector<Plot>& plots, std::set<std::string> earlier) {
  if (plots.empty()) return;
  std::error_code failure;
  fs::create_directory(folder, failure);
  if (failure) throw OutputError(folder.string() + ": cannot be made (" + failure.message() + ")");
  for (size_t i = 0; i < plots.size(); ++i) {
    const std::string name = figure_file_name(i + 1, plots[i]);
    write_output_file((folder / name).string(), figure_csv(plots[i]));
    earlier.erase(name);
  }
  for (const std::string& name : earlier) fs::remove(folder / name, failure);
}

[[noreturn]] void refuse_place(const std::string& directory, const std::string& reason) {
  throw OutputError(directory + ": expected a folder for the report, or a place to make one" +
                    (reason.empty() ? "" : " (" + reason + ")"));
}

}  // namespace

void require_place(const std::string& directory) {
  if (directory.empty()) return;
  std::error_code failure;
  fs::path place = fs::absolute(directory, failure);
  while (!fs::exists(place, failure) && place.has_relative_path()) place = place.parent_path();
  if (!fs::is_directory(place, failure)) refuse_place(directory, place.string() + " is no folder");
  if (::access(place.c_str(), W_OK | X_OK) != 0) refuse_place(directory, place.string() + " is not writable");
}

void write_page(const std::string& directory, const Page& page) {
  std::error_code failure;
  const bool made = fs::create_directories(directory, failure);
  if (failure || !fs::is_directory(directory)) refuse_place(directory, failure ? failure.message() : "");
  const std::set<std::string> earlier = earlier_figures(directory);
  try {
    write_output_file((fs::path(directory) / "index.html").string(), page.finish());
  } catch (const OutputError&) {
    if (made) fs::remove(directory, failure);
    throw;
  }
  write_figures(fs::path(directory) / "figures", page.plots(), earlier);
}

}  // namespace host_sim::reports
