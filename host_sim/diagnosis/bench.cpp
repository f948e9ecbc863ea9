#include "bench.hpp"

#include "beyond_noise.hpp"
#include "sharpen.hpp"

namespace diagnosis {

std::vector<FusedRecord> ready(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                               const Options& options, std::vector<SensorCheck>* checks) {
  std::vector<FusedRecord> list;
  for (const host_sim::Record& r : records) {
    list.push_back(read_record(rig, r, options.top_of_band));
    estimate_noise(list.back());
    correct_hold(list.back());
    const SensorCheck check = check_sensors(list.back());
    if (checks) checks->push_back(check);
    fuse(list.back());
  }
  return list;
}

std::vector<FusedRecord> held(std::vector<FusedRecord> records, const std::vector<KnownHold>& holds) {
  for (FusedRecord& f : records) {
    for (const KnownHold& known : holds) impose_hold(f, known);
    if (!holds.empty()) fuse(f);
  }
  return records;
}

void Bench::lay_out() {
  rows = std::make_unique<Rows>(system, records);
  bank = std::make_unique<CandidateBank>(*rows);
}

void Bench::look_wide() {
  for (FusedRecord& f : records) {
    fuse(f);
    f.last_bin = end_of_motion(f);
  }
  lay_out();
  colour_by_vocabulary(*rows, *bank);
}

void sharpen_all(const System& system, std::vector<FusedRecord>& records) {
  for (int pass = 0; pass < 2; ++pass) {
    Rows rows(system, records);
    std::vector<ActiveTerm> model = base_model(rows);
    settle(rows, model, 3);
    sharpen(records, system, model);
  }
}

}  // namespace diagnosis
