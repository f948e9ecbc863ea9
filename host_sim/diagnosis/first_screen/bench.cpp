#include "bench.hpp"

#include "../record/sharpen.hpp"
#include "../terms/naming.hpp"

namespace diagnosis {
namespace {

// Delays that the rig file states are no faults to be found.
void take_out_known_delays(const rig_file::RigModel& rig, FusedRecord& f) {
  for (const rig_file::ChannelEntry& entry : rig.channels) {
    const double delay_s = 1e-6 * entry.delay_us;
    if (delay_s == 0) continue;
    for (size_t dof = 0; dof < f.spectra.size(); ++dof)
      for (size_t q = 0; q < kMotionQuantities; ++q)
        if (f.spectra[dof].measured[q] && f.spectra[dof].channel[q] == entry.name)
          correct_fault(f, {FaultKind::kDelay, dof, q, entry.name, delay_s, 0, 0, 0});
    for (size_t dof = 0; dof < f.force.size(); ++dof)
      if (f.force[dof].size() && force_channel(rig, dof) == entry.name)
        f.force[dof] -= delay_s * lateness(f.force[dof], delay_s, f);
  }
}

}  // namespace

std::vector<FusedRecord> ready(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                               const Options& options, std::vector<SensorCheck>* checks) {
  std::vector<FusedRecord> list;
  for (const host_sim::Record& r : records) {
    list.push_back(read_record(rig, r, options.top_of_band));
    take_out_known_delays(rig, list.back());
    estimate_noise(list.back());
    correct_hold(list.back());
    const SensorCheck check = check_sensors(list.back());
    if (checks) checks->push_back(check);
    fuse(list.back());
  }
  return list;
}

std::vector<FusedRecord> imposed_on(std::vector<FusedRecord> records, const Imposed& imposed) {
  if (imposed.holds.empty() && imposed.faults.empty()) return records;
  for (FusedRecord& f : records) {
    for (const KnownHold& known : imposed.holds) impose_hold(f, known);
    for (const SensorFault& fault : imposed.faults) correct_fault(f, fault);
    estimate_noise(f);
    fuse(f);
  }
  return records;
}

void Bench::lay_out() {
  rows = std::make_unique<Rows>(system, records);
  bank = std::make_unique<CandidateBank>(*rows);
}

void Bench::lay_out_sharpened() {
  sharpen_all(system, records);
  lay_out();
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
