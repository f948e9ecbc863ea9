#include "host_sim/records/record_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/times/even_times.hpp"
#include "host_sim/records/times/times_by_motion.hpp"
#include "host_sim/records/times/uneven_times.hpp"

namespace host_sim {
namespace {

constexpr double kLongestTest_s = 1e6;  // eleven days: times from there on are of a calendar

std::string seconds(double value) { return fmt::format("{:.6g} s", value); }

// A row that was written twice stands at one time and has the same in every channel, where noise would not let it; of rounded times that
// fall together the values differ. A record of held or coarse values has many such rows.
bool has_a_row_twice(const std::vector<double>& time_s, const Record& record) {
  constexpr size_t kLone = 3;
  size_t at_one_time = 0, alike = 0, still = 0;
  const auto same = [&](size_t i) {
    return std::all_of(record.channels.begin(), record.channels.end(), [&](const Channel& channel) {
      return channel.values.size() == time_s.size() && channel.values[i] == channel.values[i - 1];
    });
  };
  for (size_t i = 1; i < time_s.size(); ++i) {
    const bool together = time_s[i] == time_s[i - 1];
    if (!same(i)) {
      at_one_time += together ? 1 : 0;
      continue;
    }
    (together ? alike : still) += 1;
  }
  return !record.channels.empty() && alike > 0 && alike + at_one_time <= kLone && still == 0;
}

bool take_rounded_times(const std::vector<double>& time_s, Record& record) {
  const EvenTimes even = even_times(time_s);
  const double step = even.step_s, place = even.place_s;
  if (!(step > 0.0) || even.lost || has_a_row_twice(time_s, record)) return false;
  if (smoother_as_given(record, 0, time_s, even.time_s)) return false;
  if (place > 5.0 * step)  // half a step, by which a lost sample moves the line, is then within the 0.6
    record.notes.push_back("times are rounded to " + seconds(place) + ", more than a step of " + seconds(step) +
                           ": a lost sample would not show");
  else
    record.notes.push_back("times are rounded to " + seconds(place) + ": the step is " + seconds(step));
  record.sample_period_s = step;
  return true;
}

// The scatter of times about even steps that is more than their rounding.
double jitter_of(const std::vector<double>& time_s, double sample_period_s) {
  constexpr double kTrifle = 1e-3;  // of a step: below, it is told nowhere
  const double rms_s = line_through(time_s, counted(time_s.size())).rms;
  return rms_s > kTrifle * sample_period_s && even_times(time_s).step_s > 0.0 ? 0.0 : rms_s;
}

// Today is 2e9 s after 1970, and 2e12 ms.
void require_calendar(double first, const std::string& file) {
  constexpr double kMost_s = 1e11, kMost_ms = 1e14, kMost_us = 1e17;
  if (first < kMost_s) return;
  const char* const unit = first < kMost_ms ? "ms" : first < kMost_us ? "us" : "ns";
  throw DataFileError(file, 0,
                      fmt::format("its times begin at {:.6g} s, which no calendar has; if they are {} since 1970, name "
                                  "the unit in the head, or --unit t={}",
                                  first, unit, unit));
}

// What stands for the date in the times, as in seconds since 1970: it is said once, and the record starts at 0. Nought where the
// times are a test's own.
double take_clock(const std::vector<double>& time_s, Record& record) {
  if (time_s.empty() || std::abs(time_s.front()) < kLongestTest_s) return 0.0;
  require_calendar(std::abs(time_s.front()), record.file);
  record.notes.push_back(fmt::format("time counted from {:.15g} s", time_s.front()));
  return time_s.front();
}

}  // namespace

bool is_drive(const Channel& channel) { return channel.quantity == Quantity::kForce || channel.dof == rig_file::kBase; }

bool drives(const Channel& channel) {
  if (!is_drive(channel) || channel.values.empty()) return false;
  const double first = channel.values.front();
  return (channel.held && first != 0.0) ||
         std::any_of(channel.values.begin(), channel.values.end(), [&](double value) { return value != first; });
}

bool has_drive(const Record& record) { return std::any_of(record.channels.begin(), record.channels.end(), drives); }

bool any_has_drive(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(), has_drive);
}

Channel channel_of_name(const std::string& name, const rig_file::RigModel& model, const std::string& file,
                        size_t line) {
  const bool any = model.dofs.empty() && rig_file::parse_channel_name(name);
  const std::string fault = any ? "" : rig_file::channel_name_fault(name, model);
  if (!fault.empty()) throw DataFileError(file, line, "channel \"" + name + "\": " + fault);
  const rig_file::ChannelName parsed = *rig_file::parse_channel_name(name);
  Channel channel;
  channel.name = name;
  channel.quantity = static_cast<Quantity>(parsed.quantity);
  channel.dof = parsed.dof;
  return channel;
}

void set_time_base(const std::vector<double>& time_s, const std::function<size_t(size_t)>& line_of, Record& record) {
  if (time_s.size() < 2)
    throw DataFileError(record.file, 0, "holds " + std::to_string(time_s.size()) + " samples, expected at least 2");
  const double usual = median_step(time_s);
  const size_t uneven = first_uneven(time_s);
  if (uneven < time_s.size() && !take_rounded_times(time_s, record)) {
    throw DataFileError(record.file, line_of(uneven),
                        "t_s steps by " + seconds(time_s[uneven] - time_s[uneven - 1]) + ", expected a constant step" +
                            (usual > 0.0 ? " of " + seconds(usual) + " within 1 %" : " above 0") +
                            remedy_of_uneven(time_s, line_of));
  }
  record.start_s = time_s.front() - take_clock(time_s, record);
  if (uneven == time_s.size())
    record.sample_period_s = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
  record.time_jitter_s = uneven < time_s.size() ? 0.0 : jitter_of(time_s, record.sample_period_s);
}

void keep_times(const std::vector<double>& time_s, const std::function<size_t(size_t)>& line_of, Record& record) {
  for (size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] > time_s[i - 1]) continue;
    throw DataFileError(record.file, line_of(i),
                        "t_s steps by " + seconds(time_s[i] - time_s[i - 1]) + ", expected times that rise" +
                            remedy_of_falling(time_s, line_of));
  }
  record.time_s = time_s;
  const double clock_s = take_clock(time_s, record);
  for (double& t : record.time_s) t -= clock_s;
}

void require_motion_channels(const Record& record, const rig_file::RigModel& model) {
  const auto require = [&](int dof, bool rotates) {
    for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      if (record.find(quantity, dof) != nullptr) return;
    const auto name = [&](firmware::Quantity quantity) {
      return rig_file::format_channel_name({quantity, dof, rotates});
    };
    throw DataFileError(record.file, 0,
                        std::string("no motion of ") +
                            (dof == rig_file::kBase ? "the base" : "DOF " + std::to_string(dof)) +
                            " is recorded, expected a column " + name(firmware::Quantity::kDisplacement) + ", " +
                            name(firmware::Quantity::kVelocity) + " or " + name(firmware::Quantity::kAcceleration) +
                            ", or --column for one with a name of its own");
  };
  for (size_t i = 0; i < model.dofs.size(); ++i) require(static_cast<int>(i + 1), model.dofs[i].rotating);
  for (const rig_file::Link& link : model.links)
    if (link.b == rig_file::kBase) require(rig_file::kBase, rig_file::link_rotates(model, link));
}

std::vector<const Channel*> channels_beyond(const Record& record, const Record& other) {
  std::vector<const Channel*> beyond;
  for (const Channel& channel : record.channels)
    if (other.find(channel.quantity, channel.dof) == nullptr) beyond.push_back(&channel);
  return beyond;
}

bool same_period(const Record& a, const Record& b) {
  constexpr double kTolerance = 1e-3;  // all are counted at one rate, and a spring goes with its square
  return std::abs(a.sample_period_s / b.sample_period_s - 1.0) <= kTolerance;
}

void require_same_channels(const std::vector<Record>& records) { require_same_channels(records.front(), records); }

void require_same_channels(const Record& first, const std::vector<Record>& records) {
  for (const Record& record : records) {
    if (!same_period(record, first))
      throw DataFileError(record.file, 0,
                          "sampled every " + seconds(record.sample_period_s) + ", expected " +
                              seconds(first.sample_period_s) + " as in " + first.file +
                              " (--resample brings them to one rate)");
    const std::string as_in_first = ", expected the same channels as in " + first.file;
    const std::vector<const Channel*> lacks = channels_beyond(first, record), has = channels_beyond(record, first);
    if (!lacks.empty()) throw DataFileError(record.file, 0, "lacks " + lacks.front()->name + as_in_first);
    if (!has.empty()) throw DataFileError(record.file, 0, "has " + has.front()->name + as_in_first);
  }
}

void order_channels_as(const Record& first, std::vector<Record>& records) {
  const auto place = [&](const Channel& channel) {
    return std::find_if(first.channels.begin(), first.channels.end(), [&](const Channel& of_first) {
      return of_first.quantity == channel.quantity && of_first.dof == channel.dof;
    });
  };
  for (Record& record : records)
    if (&record != &first)
      std::stable_sort(record.channels.begin(), record.channels.end(),
                       [&](const Channel& a, const Channel& b) { return place(a) < place(b); });
}

}  // namespace host_sim
