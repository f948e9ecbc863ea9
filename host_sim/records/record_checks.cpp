#include "host_sim/records/record_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/records/data_file_error.hpp"

namespace host_sim {
namespace {

constexpr double kStepTolerance = 0.01;

std::string seconds(double value) { return fmt::format("{:.6g} s", value); }

// Least squares of t[i] = start + index[i] step, and what is left.
struct TimeLine {
  double start = 0.0, step = 0.0, rms = 0.0, largest = 0.0;
};

TimeLine line_through(const std::vector<double>& time_s, const std::vector<double>& index) {
  const auto n = static_cast<double>(time_s.size());
  double middle = 0.0, mean = 0.0, moment = 0.0, spread = 0.0;
  for (size_t i = 0; i < time_s.size(); ++i) middle += index[i] / n, mean += (time_s[i] - time_s[0]) / n;
  for (size_t i = 0; i < time_s.size(); ++i) {
    moment += (index[i] - middle) * (time_s[i] - time_s[0] - mean);
    spread += (index[i] - middle) * (index[i] - middle);
  }
  TimeLine line;
  line.step = moment / spread;
  line.start = time_s[0] + mean - middle * line.step;
  double squares = 0.0;
  for (size_t i = 0; i < time_s.size(); ++i) {
    const double off = time_s[i] - line.start - index[i] * line.step;
    squares += off * off;
    line.largest = std::max(line.largest, std::abs(off));
  }
  line.rms = std::sqrt(squares / n);
  return line;
}

std::vector<double> counted(size_t samples) {
  std::vector<double> index(samples);
  for (size_t i = 0; i < samples; ++i) index[i] = static_cast<double>(i);
  return index;
}

// The place of the last decimal that any of the times has: 0.001 for 0.977 and 1.95. Times of so many significant digits
// have fewer decimals the later they are, so those of the last decade count. Numbers of single precision without a last
// decimal: their spacing there. 0 where there is none.
double last_decimal(const std::vector<double>& time_s) {
  double latest = 0.0;
  for (const double t : time_s) latest = std::max(latest, std::abs(t));
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(latest, 1e-9))));
  double place = 1.0;
  for (int decimals = 0; decimals <= 9; ++decimals, place *= 0.1) {
    bool whole = true;
    for (size_t i = 0; whole && i < time_s.size(); ++i) {
      const double units = time_s[i] / place;
      whole = std::abs(time_s[i]) < decade || std::abs(units - std::nearbyint(units)) < 1e-3;
    }
    if (whole) return place;
  }
  const auto single = [](double t) { return static_cast<double>(static_cast<float>(t)) == t; };
  const auto upper = static_cast<float>(latest);
  return std::all_of(time_s.begin(), time_s.end(), single) ? std::nextafterf(upper, 2.0F * upper) - upper : 0.0;
}

// How far from even steps times may lie, in units of their last decimal. Even times that were rounded lie within half a
// unit of a line (the line through rounded times may miss the true one by a little, so 0.6). Those of a clock that is
// read beside an even sampling, in whole ticks, lie within one. A sample that is missing throws them off by half a step.
constexpr double kRounded = 0.6, kTick = 1.0, kTicksOfAStep = 4.0;

}  // namespace

EvenTimes even_times(const std::vector<double>& time_s) {
  EvenTimes even;
  const double place = last_decimal(time_s), usual = median_step(time_s);
  if (place == 0.0 || time_s.size() < 16) return even;
  std::vector<double> index = counted(time_s.size());
  const bool shows_lost = usual >= kTicksOfAStep * place;
  for (size_t i = 1; shows_lost && i < index.size(); ++i)
    index[i] = index[i - 1] + std::round((time_s[i] - time_s[i - 1]) / usual);
  const TimeLine line = line_through(time_s, index);
  if (!(line.step > 0.0) || line.largest > (shows_lost ? kTick : kRounded) * place) return even;
  even.step_s = line.step, even.place_s = place;
  even.lost = index.back() + 1 > static_cast<double>(index.size());
  for (const double i : index) even.time_s.push_back(line.start + i * line.step);
  return even;
}

namespace {

bool take_rounded_times(const std::vector<double>& time_s, Record& record) {
  const EvenTimes even = even_times(time_s);
  const double step = even.step_s, place = even.place_s;
  if (!(step > 0.0) || even.lost) return false;
  if (place > 5.0 * step)  // half a step, by which a lost sample moves the line, is then within the 0.6
    record.notes.push_back("times are rounded to " + seconds(place) + ", more than a step of " + seconds(step) +
                           ": a lost sample would not show");
  else
    record.notes.push_back("times are rounded to " + seconds(place) + ": the step is " + seconds(step));
  record.sample_period_s = step;
  return true;
}

}  // namespace

double median_step(const std::vector<double>& time_s) {
  std::vector<double> steps(time_s.size() - 1);
  for (size_t i = 0; i < steps.size(); ++i) steps[i] = time_s[i + 1] - time_s[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
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
  size_t uneven = 1;
  while (uneven < time_s.size() && usual > 0.0 &&
         std::abs(time_s[uneven] - time_s[uneven - 1] - usual) <= kStepTolerance * usual)
    ++uneven;
  if (uneven < time_s.size() && !take_rounded_times(time_s, record))
    throw DataFileError(record.file, line_of(uneven),
                        "t_s steps by " + seconds(time_s[uneven] - time_s[uneven - 1]) + ", expected a constant step" +
                            (usual > 0.0 ? " of " + seconds(usual) + " within 1 %" : " above 0") +
                            (usual > 0.0 ? fmt::format("; --resample {:.0f} interpolates", 1.0 / usual) : ""));
  record.start_s = time_s.front();
  if (uneven == time_s.size())
    record.sample_period_s = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
  record.time_jitter_s = line_through(time_s, counted(time_s.size())).rms;
}

void keep_times(const std::vector<double>& time_s, const std::function<size_t(size_t)>& line_of, Record& record) {
  for (size_t i = 1; i < time_s.size(); ++i)
    if (!(time_s[i] > time_s[i - 1]))
      throw DataFileError(record.file, line_of(i),
                          "t_s steps by " + seconds(time_s[i] - time_s[i - 1]) + ", expected times that rise");
  record.time_s = time_s;
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
                            name(firmware::Quantity::kVelocity) + " or " + name(firmware::Quantity::kAcceleration));
  };
  for (size_t i = 0; i < model.dofs.size(); ++i) require(static_cast<int>(i + 1), model.dofs[i].rotating);
  for (const rig_file::Link& link : model.links)
    if (link.b == rig_file::kBase) require(rig_file::kBase, rig_file::link_rotates(model, link));
}

void require_same_channels(const std::vector<Record>& records) { require_same_channels(records.front(), records); }

void require_same_channels(const Record& first, const std::vector<Record>& records) {
  for (const Record& record : records) {
    if (std::abs(record.sample_period_s / first.sample_period_s - 1.0) > kStepTolerance)
      throw DataFileError(record.file, 0,
                          "sampled every " + seconds(record.sample_period_s) + ", expected " +
                              seconds(first.sample_period_s) + " as in " + first.file);
    for (const Channel& channel : first.channels)
      if (record.find(channel.quantity, channel.dof) == nullptr)
        throw DataFileError(record.file, 0,
                            "lacks " + channel.name + ", expected the same channels as in " + first.file);
    for (const Channel& channel : record.channels)
      if (first.find(channel.quantity, channel.dof) == nullptr)
        throw DataFileError(record.file, 0, "has " + channel.name + ", expected the same channels as in " + first.file);
  }
}

}  // namespace host_sim
