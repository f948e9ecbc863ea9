// Writes a drawn rig and its records for anybody to run host_sim on: rig.toml, record_1.csv, ..., truth.json.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "draw.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/records/csv/csv_writer.hpp"

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text).flush()) throw std::runtime_error(path.string() + " cannot be written");
}

void list() {
  std::printf("conditions:");
  for (const hidden_rig::Condition& c : hidden_rig::conditions()) std::printf(" %s", c.name.c_str());
  std::printf("\nhidden: none any two");
  for (const std::string& word : hidden_rig::effects()) std::printf(" %s", word.c_str());
  std::printf("\nsensors: any of x, v, a together, or mixed\n");
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Draws a rig with records and a truth that its rig file may not hold");
  hidden_rig::Settings settings;
  uint64_t seed = 1;
  std::string out;
  bool listing = false;
  app.add_option("--condition", settings.condition, "name of a condition");
  app.add_option("--seed", seed, "the same seed gives the same bytes");
  app.add_option("--sensors", settings.sensors, "x, v, a, xa, xva, ... of every DOF, or mixed");
  app.add_option("--hidden", settings.hidden, "an effect, any, two or none");
  app.add_option("--masses", settings.masses, "how many; 0: as the condition draws");
  app.add_option("--rho-low", settings.rho_low, "weakest hidden force, as a share of the damping force of its link");
  app.add_option("--rho-high", settings.rho_high, "strongest");
  app.add_option("--out", out, "folder for rig.toml, record_1.csv, ... and truth.json");
  app.add_flag("--list", listing, "names of conditions and effects");
  CLI11_PARSE(app, argc, argv);
  if (listing) {
    list();
    return 0;
  }
  if (out.empty()) throw std::invalid_argument("--out is missing, expected a folder");
  const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
  std::filesystem::create_directories(out);
  write(std::filesystem::path(out) / "rig.toml", rig_file::format_rig(draw.rig));
  for (const host_sim::Record& record : draw.records)
    write(std::filesystem::path(out) / record.file, host_sim::format_csv(record));
  write(std::filesystem::path(out) / "truth.json", hidden_rig::truth_json(seed, settings, draw));
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "hidden_rig_files: %s\n", e.what());
  return 2;
}
