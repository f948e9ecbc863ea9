#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <set>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/between_channels/coupling.hpp"
#include "host_sim/data_check/between_channels/duplicate.hpp"
#include "host_sim/data_check/between_channels/exchanged.hpp"
#include "host_sim/data_check/between_channels/kinematics.hpp"
#include "host_sim/data_check/channel/ripple.hpp"
#include "host_sim/data_check/channel/slow_faults.hpp"
#include "host_sim/data_check/channel/spikes.hpp"
#include "host_sim/data_check/channel/staircase.hpp"
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/decay/growth.hpp"
#include "host_sim/data_check/decay/release.hpp"
#include "host_sim/data_check/drive/excitation.hpp"
#include "host_sim/data_check/drive/work.hpp"
#include "host_sim/data_check/flat/clipping.hpp"
#include "host_sim/data_check/flat/dead.hpp"
#include "host_sim/data_check/flat/frozen.hpp"
#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/data_check/rig/rig_balance.hpp"
#include "host_sim/data_check/time_base/short_record.hpp"
#include "host_sim/data_check/time_base/time_unit.hpp"
#include "host_sim/data_check/together/unlike.hpp"

namespace host_sim::data_check {
namespace {

bool rotates(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return name && name->rotating;
}

bool changes(const Channel& channel) {
  return std::any_of(channel.values.begin(), channel.values.end(),
                     [&](double value) { return value != channel.values.front(); });
}

// How often the estimation differentiates a channel: as often as no other channel of the DOF spares it.
int differentiated(const Record& record, const Channel& channel) {
  const bool velocity = record.find(Quantity::kVelocity, channel.dof) != nullptr,
             acceleration = record.find(Quantity::kAcceleration, channel.dof) != nullptr;
  if (channel.quantity == Quantity::kDisplacement) return velocity || acceleration ? (velocity ? 0 : 1) : 2;
  if (channel.quantity == Quantity::kVelocity) return acceleration ? 0 : 1;
  return 0;
}

// What the velocity of a DOF spans, from its velocity or displacement; 0 where neither is there.
double velocity_range(const Record& record, const std::vector<Statistics>& statistics, int dof) {
  if (const Channel* velocity = record.find(Quantity::kVelocity, dof))
    return statistics[static_cast<size_t>(velocity - record.channels.data())].range;
  const Channel* displacement = record.find(Quantity::kDisplacement, dof);
  if (displacement == nullptr || displacement->values.size() < 8) return 0.0;
  std::vector<double> velocity(displacement->values.size() - 4);
  for (size_t i = 0; i < velocity.size(); ++i)
    velocity[i] = (displacement->values[i + 4] - displacement->values[i]) / (4.0 * record.sample_period_s);
  return quantile(velocity, 0.999) - quantile(velocity, 0.001);
}

double velocity_step(const Record& record, const Channel& channel, const rig_file::RigModel* model) {
  if (channel.quantity == Quantity::kAcceleration) return record.sample_period_s;
  if (channel.quantity != Quantity::kForce || model == nullptr || channel.dof < 1) return 0.0;
  const rig_file::Coefficient& mass = model->dofs[static_cast<size_t>(channel.dof - 1)].mass_kg;
  return mass.estimate || !(mass.value > 0.0) ? 0.0 : record.sample_period_s / mass.value;
}

// The converter's ends in SI, where the rig file knows them.
std::pair<double, double> converter_limits(const Channel& channel, const rig_file::RigModel* model) {
  const rig_file::ChannelEntry* const entry = model == nullptr ? nullptr : rig_file::entry_of(*model, channel.name);
  if (entry == nullptr || entry->unit_per_code == 0.0 || entry->highest_code <= entry->lowest_code) return {0.0, 0.0};
  const double a = (entry->lowest_code - entry->offset_code) * entry->unit_per_code,
               b = (entry->highest_code - entry->offset_code) * entry->unit_per_code;
  return {std::min(a, b), std::max(a, b)};
}

// all: the statistics of every channel of the record.
ChannelReport report_of(const Record& record, const std::vector<Statistics>& all, size_t index,
                        const rig_file::RigModel* model) {
  const Channel& channel = record.channels[index];
  const Statistics& statistics = all[index];
  ChannelReport report{channel.name, statistics.rms, statistics.mean, statistics.noise, statistics.resolution, {}};
  if (statistics.lowest == statistics.highest) return report;
  Neighbours neighbours{record.sample_period_s, differentiated(record, channel), 0.0, 0.0, {}};
  for (size_t i = 0; i < all.size(); ++i)
    if (record.channels[i].quantity == Quantity::kForce) neighbours.forces.push_back({&record.channels[i], &all[i]});
  if (channel.dof >= 1) {
    neighbours.velocity_step = velocity_step(record, channel, model);
    if (neighbours.velocity_step > 0.0) neighbours.velocity_range = velocity_range(record, all, channel.dof);
  }
  if (auto spikes = find_spikes(channel, statistics, neighbours)) {
    report.findings.push_back(std::move(*spikes));
  } else {
    const auto [low, high] = converter_limits(channel, model);
    if (auto clipped = find_clipping(channel, statistics, low, high, &record))
      report.findings.push_back(std::move(*clipped));
  }
  if (auto staircase = find_staircase(record, channel, statistics)) report.findings.push_back(std::move(*staircase));
  for (Finding& finding : find_slow_faults(record, channel, statistics)) report.findings.push_back(std::move(finding));
  if (model != nullptr)
    if (auto ripple = find_ripple(record, channel, *model)) report.findings.push_back(std::move(*ripple));
  return report;
}

void attach(std::vector<Finding> findings, RecordReport& report) {
  for (Finding& finding : findings) {
    const auto place = std::find_if(report.channels.begin(), report.channels.end(),
                                    [&](const ChannelReport& channel) { return channel.name == finding.channel; });
    (place == report.channels.end() ? report.findings : place->findings).push_back(std::move(finding));
  }
}

template <typename Is>
bool any_finding(const RecordReport& report, Is is) {
  return std::any_of(report.findings.begin(), report.findings.end(), is) ||
         std::any_of(report.channels.begin(), report.channels.end(), [&](const ChannelReport& channel) {
           return std::any_of(channel.findings.begin(), channel.findings.end(), is);
         });
}

bool has_fault(const RecordReport& report, const char* kind = nullptr) {
  return any_finding(
      report, [kind](const Finding& f) { return f.weight == Weight::kFault && (kind == nullptr || f.kind == kind); });
}

// Whether a part of the record that estimate and diagnose keep has this fault too.
bool is_in(const std::vector<Record>& kept, const Finding& fault, const rig_file::RigModel* model) {
  return std::any_of(kept.begin(), kept.end(), [&](const Record& part) {
    std::vector<Statistics> statistics;
    for (const Channel& channel : part.channels) statistics.push_back(statistics_of(channel));
    for (size_t i = 0; i < part.channels.size(); ++i)
      for (const Finding& finding : report_of(part, statistics, i, model).findings)
        if (finding.kind == fault.kind && finding.channel == fault.channel && finding.weight == Weight::kFault)
          return true;
    return false;
  });
}

// A clipped blow, spikes from the hand that lets go: what is left out of a free decay harms nobody.
void forgive_what_is_left_out(const Record& record, const rig_file::RigModel* model, RecordReport& report) {
  std::vector<Record> kept = {record};
  if (keep_decays(kept).empty()) return;
  for (ChannelReport& channel : report.channels)
    for (Finding& finding : channel.findings)
      if (finding.weight == Weight::kFault && !is_in(kept, finding, model)) {
        finding.weight = Weight::kInforms;
        finding.detail += "; estimate and diagnose leave that part out";
      }
}

// Channels are compared over at most that many samples from the middle of a record: enough to say, and no time lost.
constexpr size_t kMostCompared = 1 << 17;
const Record& middle_of(const Record& record, Record& part) {
  if (record.samples() <= kMostCompared) return record;
  part.file = record.file;
  part.sample_period_s = record.sample_period_s;
  const size_t count = kMostCompared, first = (record.samples() - count) / 2;
  for (const Channel& channel : record.channels) {
    const auto begin = channel.values.begin() + static_cast<std::ptrdiff_t>(first);
    part.channels.push_back({channel.name, channel.quantity, channel.dof,
                             std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count)),
                             channel.recorded_step, channel.held});
  }
  return part;
}

RecordReport check_record(const Record& record, const rig_file::RigModel* model, const std::vector<bool>& elsewhere,
                          const Drive& drive) {
  RecordReport report{record.file, record.samples(), 1.0 / record.sample_period_s, {}, {}};
  std::vector<std::optional<Finding>> dead = find_dead(record, elsewhere);
  std::vector<Statistics> statistics;
  for (const Channel& channel : record.channels) statistics.push_back(statistics_of(channel));
  for (size_t i = 0; i < record.channels.size(); ++i)
    report.channels.push_back(report_of(record, statistics, i, model));
  if (has_fault(report)) forgive_what_is_left_out(record, model, report);
  for (size_t i = 0; i < record.channels.size(); ++i)
    if (dead[i]) report.channels[i].findings.push_back(std::move(*dead[i]));
  if (!has_fault(report)) attach(find_frozen(record, statistics), report);
  if (auto few = find_short(record)) report.findings.push_back(std::move(*few));
  attach(find_duplicates(record), report);
  if (auto jitter = find_jitter(record)) report.findings.push_back(std::move(*jitter));
  if (has_fault(report)) return report;  // what follows compares channels: one that is broken would be blamed on others
  Record middle;
  const Record& compared = middle_of(record, middle);
  {
    Integrals integrals;
    std::set<int> dofs;
    for (const Channel& channel : compared.channels)
      if (dofs.insert(channel.dof).second)
        attach(check_kinematics(compared, channel.dof, rotates(channel), model, integrals), report);
    attach(check_exchanged(compared, integrals), report);
  }
  if (!has_fault(report)) attach(find_ac_coupling(compared, model), report);
  find_time_unit(record, model, report);
  if (model != nullptr && !has_fault(report)) attach(check_rig_balance(compared, *model), report);
  if (!has_fault(report) && !any_finding(report, [](const Finding& f) { return f.kind == "polarity"; }))
    if (auto work = find_negative_work(compared, drive)) attach({std::move(*work)}, report);
  if (!has_fault(report))
    if (auto growth = find_growth(record)) attach({std::move(*growth)}, report);
  if (!has_fault(report))
    if (auto release = find_release(record)) attach({std::move(*release)}, report);
  return report;
}

// A cable in the wrong place is there in every record; what one record alone says is the rig's doing.
void keep_what_all_records_say(const char* kind, Report& report) {
  const auto is_kind = [kind](const Finding& f) { return f.kind == kind; };
  std::set<std::string> doubtful;  // channels of which some record does not say it
  for (const RecordReport& record : report.records)
    for (const ChannelReport& channel : record.channels)
      if (std::none_of(channel.findings.begin(), channel.findings.end(), is_kind)) doubtful.insert(channel.name);
  for (RecordReport& record : report.records)
    for (ChannelReport& channel : record.channels)
      if (doubtful.count(channel.name) > 0)
        channel.findings.erase(std::remove_if(channel.findings.begin(), channel.findings.end(), is_kind),
                               channel.findings.end());
}

}  // namespace

Weight Report::worst() const {
  Weight worst = Weight::kInforms;
  const auto take = [&worst](const std::vector<Finding>& list) {
    for (const Finding& finding : list) worst = std::max(worst, finding.weight);
  };
  take(findings);
  for (const RecordReport& record : records) {
    take(record.findings);
    for (const ChannelReport& channel : record.channels) take(channel.findings);
  }
  return worst;
}

const char* Report::verdict() const {
  switch (worst()) {
    case Weight::kInforms:
      return "good";
    case Weight::kDoubt:
      return "usable";
    case Weight::kFault:
      return "unusable";
  }
  return "unusable";
}

Report check(const std::vector<Record>& records, const rig_file::RigModel* model) {
  Report report;
  std::vector<Drive> drives(records.size());
  std::vector<std::future<RecordReport>> checks;  // beside each other; the order of the answers is that of the records
  for (const Record& record : records) {
    std::vector<bool> elsewhere;
    for (const Channel& channel : record.channels)
      elsewhere.push_back(std::any_of(records.begin(), records.end(), [&](const Record& other) {
        const Channel* same = &other == &record ? nullptr : other.find(channel.quantity, channel.dof);
        return same != nullptr && changes(*same);
      }));
    const auto policy = records.size() > 1 ? std::launch::async : std::launch::deferred;
    checks.push_back(std::async(policy, [&record, &drive = drives[checks.size()], model, moves = std::move(elsewhere)] {
      drive = drive_of(record);
      return check_record(record, model, moves, drive);
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
