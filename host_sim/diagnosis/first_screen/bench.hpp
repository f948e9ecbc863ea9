// Records made ready for the diagnosis, and the rows and candidates that are laid over them.
#pragma once
#include <memory>
#include <vector>

#include "../diagnosis.hpp"
#include "../search/candidates.hpp"
#include "../sensors/drive_hold.hpp"
#include "../sensors/sensor_check.hpp"

namespace diagnosis {

// Fused records, corrected for the sensor faults that are found (collected where `checks` is given).
std::vector<FusedRecord> ready(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                               const Options& options, std::vector<SensorCheck>* checks);

// Two rounds of fitting the rig as given and sharpening the motion by it.
void sharpen_all(const System& system, std::vector<FusedRecord>& records);

// What the rig's equations, not the record alone, told of how a record is to be read.
struct Imposed {
  std::vector<KnownHold> holds;
  std::vector<SensorFault> faults;
};
// Records read so, fused anew.
std::vector<FusedRecord> imposed_on(std::vector<FusedRecord> records, const Imposed& imposed);

struct Bench {
  const System& system;
  std::vector<FusedRecord> records;
  Imposed imposed;  // on the records
  std::unique_ptr<Rows> rows = nullptr;
  std::unique_ptr<CandidateBank> bank = nullptr;
  void lay_out();
  void lay_out_sharpened();  // after sharpen_all()
};

}  // namespace diagnosis
