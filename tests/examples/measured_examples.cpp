// measured_examples RECORDINGS_DIR DOCS_DIR: diagnoses the recordings of three real rigs and writes what came of it as
// DOCS_DIR/examples_measured.md with DOCS_DIR/pictures/*.svg.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/ingestion/record_reader.hpp"
#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/data/from_diagnosis.hpp"
#include "tests/examples/example_page.hpp"

namespace {

std::vector<host_sim::Record> read(const std::string& folder, const std::vector<std::string>& files,
                                   const rig_file::RigModel& rig) {
  std::vector<host_sim::Record> records;
  for (const std::string& file : files) records.push_back(host_sim::read_record(folder + "/" + file, rig));
  return records;
}

std::string section_of(const examples::Example& example, const std::string& recordings, const std::string& docs) {
  const rig_file::RigModel rig = rig_file::read_rig_file(docs + "/examples/" + example.rig);
  const std::vector<host_sim::Record> data = read(recordings, example.data, rig);
  const std::vector<host_sim::Record> holdout = read(recordings, example.holdout, rig);
  const diagnosis::Options options;
  const diagnosis::Diagnosis found = diagnosis::diagnose(rig, data, holdout, options);
  host_sim::reports::DiagnosisReportData report = host_sim::reports::findings_of(rig, data, holdout, found);
  host_sim::reports::add_pictures(rig, data, holdout, found, report);
  return examples::section(example, report, docs);
}

constexpr char kOpening[] =
    "# Worked examples: three real rigs\n\n"
    "Recordings of real rigs, each diagnosed with a rig file that says too little. The rig files are in\n"
    "[examples](examples). The recordings are published by others and not part of this project. Each section says "
    "where,\n"
    "and which command makes CSV files of them in a folder `recordings` (`apt install python3-scipy`). With all of "
    "them\n"
    "there, everything on this page, numbers and pictures, is written by\n\n"
    "    build/host/bin/measured_examples recordings docs\n\n"
    "Each `diagnose` command below makes the full report ([reports.md](reports.md)). In brackets: 95 % intervals.\n\n";

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("measured_examples RECORDINGS_DIR DOCS_DIR\n", stderr);
    return 2;
  }
  try {
    const std::string recordings = arguments[1], docs = arguments[2];
    std::filesystem::create_directories(docs + "/pictures");
    std::string page = kOpening;
    for (const examples::Example& example : examples::all()) page += section_of(example, recordings, docs);
    while (page.size() > 1 && page[page.size() - 2] == '\n') page.pop_back();
    host_sim::write_output_file(docs + "/examples_measured.md", page);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
