// The rooms in the order in which a record flows through them: each channel on its own (channel, spikes, flat), the times (time_base),
// channels of one motion (one_motion) and of two (between_dofs), masses and springs (rig), forces (drive), free decays (decay, by the
// energies of its windows), then all records (together) and what is said (report). All compute with measures.
#include <algorithm>
#include <future>
#include <set>
#include <utility>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/between_dofs/duplicate.hpp"
#include "host_sim/data_check/between_dofs/exchanged.hpp"
#include "host_sim/data_check/channel/channel_report.hpp"
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/decay/forgiven.hpp"
#include "host_sim/data_check/decay/growth.hpp"
#include "host_sim/data_check/decay/release.hpp"
#include "host_sim/data_check/decay/undying.hpp"
#include "host_sim/data_check/drive/excitation.hpp"
#include "host_sim/data_check/drive/idle_force.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"
#include "host_sim/data_check/drive/work.hpp"
#include "host_sim/data_check/flat/dead.hpp"
#include "host_sim/data_check/flat/frozen.hpp"
#include "host_sim/data_check/measures/middle.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/data_check/one_motion/coupling.hpp"
#include "host_sim/data_check/one_motion/kinematics.hpp"
#include "host_sim/data_check/report/record_findings.hpp"
#include "host_sim/data_check/rig/rig_balance.hpp"
#include "host_sim/data_check/time_base/jitter.hpp"
#include "host_sim/data_check/time_base/short_record.hpp"
#include "host_sim/data_check/time_base/time_unit.hpp"
#include "host_sim/data_check/together/said_by_all.hpp"
#include "host_sim/data_check/together/unlike.hpp"

namespace host_sim::data_check {
namespace {

bool rotates(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return name && name->rotating;
}

// Each channel on its own, and the times. elsewhere: of each channel, whether it moves in another record.
RecordReport check_channels(const Record& record, const rig_file::RigModel* model, const std::vector<bool>& elsewhere) {
  RecordReport report{record.file, record.samples(), 1.0 / record.sample_period_s, {}, {}};
  std::vector<std::optional<Finding>> dead = find_dead(record, elsewhere);
  const std::vector<Statistics> statistics = statistics_of(record);
  for (size_t i = 0; i < record.channels.size(); ++i)
    report.channels.push_back(report_of(record, statistics, i, model));
  if (has_fault(report)) forgive_what_is_left_out(record, model, report);
  for (size_t i = 0; i < record.channels.size(); ++i)
    if (dead[i]) report.channels[i].findings.push_back(std::move(*dead[i]));
  if (!has_fault(report)) attach(find_frozen(record, statistics), report);
  if (auto few = find_short(record)) report.findings.push_back(std::move(*few));
  attach(find_duplicates(record), report);
  if (auto jitter = find_jitter(record)) report.findings.push_back(std::move(*jitter));
  return report;
}

// Channels of one motion beside each other, and beside those of other DOFs.
void compare_channels(const Record& compared, const rig_file::RigModel* model, RecordReport& report) {
  Integrals integrals;
  std::set<int> dofs;
  for (const Channel& channel : compared.channels)
    if (dofs.insert(channel.dof).second)
      attach(check_kinematics(compared, channel.dof, rotates(channel), model, integrals), report);
  attach(check_exchanged(compared, integrals), report);
}

// What takes several channels; drive: what drives the record.
void check_motion(const Record& record, const rig_file::RigModel* model, const Drive& drive, RecordReport& report) {
  Record middle;
  const Record& compared = middle_of(record, middle);
  compare_channels(compared, model, report);
  if (!has_fault(report))
    attach(find_ac_coupling(compared, model, drive.lines_Hz.empty() ? 0.0 : drive.lines_Hz.back()), report);
  find_time_unit(record, model, report);
  if (model != nullptr && !has_fault(report)) attach(check_rig_balance(compared, *model), report);
  if (!has_fault(report) && !any_finding(report, [](const Finding& f) { return f.kind == "polarity"; }))
    if (auto work = find_negative_work(compared, drive)) attach({std::move(*work)}, report);
  if (!has_fault(report))
    if (auto growth = find_growth(record)) attach({std::move(*growth)}, report);
  if (!has_fault(report))
    if (auto idle = find_idle_force(record)) attach({std::move(*idle)}, report);
  if (!has_fault(report))
    if (auto undying = find_undying(record)) attach({std::move(*undying)}, report);
  if (!has_fault(report))
    if (auto release = find_release(record)) attach({std::move(*release)}, report);
}

// Of each channel of a record, whether it changes in another one.
std::vector<bool> moves_elsewhere(const Record& record, const std::vector<Record>& records) {
  std::vector<bool> elsewhere;
  for (const Channel& channel : record.channels)
    elsewhere.push_back(std::any_of(records.begin(), records.end(), [&](const Record& other) {
      const Channel* same = &other == &record ? nullptr : other.find(channel.quantity, channel.dof);
      return same != nullptr && !is_constant(*same);
    }));
  return elsewhere;
}

}  // namespace

Report check(const std::vector<Record>& records, const rig_file::RigModel* model) {
  Report report;
  std::vector<Drive> drives(records.size());
  std::vector<std::future<RecordReport>> checks;  // beside each other; the order of the answers is that of the records
  for (const Record& record : records) {
    const auto policy = records.size() > 1 ? std::launch::async : std::launch::deferred;
    checks.push_back(
        std::async(policy, [&record, &drive = drives[checks.size()], model, moves = moves_elsewhere(record, records)] {
          drive = drive_of(record);
          RecordReport said = check_channels(record, model, moves);
          // what follows compares channels: one that is broken would be blamed on others
          if (!has_fault(said)) check_motion(record, model, drive, said);
          return said;
        }));
  }
  for (std::future<RecordReport>& done : checks) report.records.push_back(done.get());
  keep_what_all_records_say("exchanged", report);
  if (!records.empty()) require_one_sign(report);
  report.findings = describe_excitation(records, drives);
  for (Finding& finding : find_unlike(records)) report.findings.push_back(std::move(finding));
  return report;
}

}  // namespace host_sim::data_check
