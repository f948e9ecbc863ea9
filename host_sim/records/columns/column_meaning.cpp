#include "host_sim/records/columns/column_meaning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/records/columns/column_name.hpp"
#include "host_sim/records/columns/plain_name.hpp"
#include "host_sim/records/columns/units.hpp"
#include "host_sim/records/data_file_error.hpp"

namespace host_sim {
namespace {

using rig_file::ChannelName;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return result + (text.size() > 40 ? "...\"" : "\"");
}

std::string number(double value) { return fmt::format("{:.10g}", value); }

bool is_time_choice(const std::string& channel) { return channel == "t" || channel == "t_s" || channel == "time"; }

// The rig's name for what the user calls "force_1" or "force_1_N"; as it stands where it is no channel.
std::string full_name(const std::string& channel) {
  if (rig_file::parse_channel_name(channel)) return channel;
  const auto loose = parse_loose_name(channel);
  return loose && loose->suffix.empty() ? rig_file::format_channel_name(loose->channel) : channel;
}

// What the user chose for a channel: the command line first, then the rig file.
std::string chosen(const ReadingOptions::Choices& choices, const rig_file::RigModel& model, const std::string& channel,
                   std::string rig_file::ChannelEntry::*field) {
  for (const auto& [name, text] : choices)
    if (full_name(name) == channel) return text;
  const rig_file::ChannelEntry* const entry = rig_file::entry_of(model, channel);
  return entry == nullptr ? "" : entry->*field;
}

class Planner {
 public:
  Planner(const rig_file::RigModel& model, const ReadingOptions& options, const std::string& file, size_t line)
      : model_(model), options_(options), file_(file), line_(line) {}

  ColumnPlan plan(const std::vector<Column>& columns) {
    plan_.uses.resize(columns.size());
    check_choices(columns);
    for (size_t i = 0; i < columns.size(); ++i) use(columns, i);
    if (model_.dofs.size() <= 1 && !own_names_) take_plain(columns);
    take_time(columns);
    note_ignored(columns);
    return std::move(plan_);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const { throw DataFileError(file_, line_, problem); }

  // By its name, or by its place from 1, "#5": names may be there twice, or empty.
  static bool is_head(const std::vector<Column>& columns, size_t i, const std::string& text) {
    const Column& column = columns[i];
    if (text == "#" + std::to_string(i + 1)) return true;
    return trimmed_text(column.head) == trimmed_text(text) || split_head(column.head).name == trimmed_text(text);
  }

  void check_choices(const std::vector<Column>& columns) const {
    for (const auto& [channel, head] : options_.columns) {
      if (!is_time_choice(channel)) require_channel(full_name(channel));
      if (head.empty()) continue;
      std::vector<size_t> found;
      for (size_t i = 0; i < columns.size(); ++i)
        if (is_head(columns, i, head)) found.push_back(i + 1);
      if (found.size() == 1) continue;
      if (!found.empty())
        refuse(fmt::format("has {} columns {} for {}, expected one: take it by its place, {}=#{} or {}=#{}",
                           found.size(), quoted(head), channel, channel, found[0], channel, found[1]));
      std::string heads;
      for (const Column& column : columns) heads += (heads.empty() ? "" : ", ") + quoted(trimmed_text(column.head));
      refuse("has no column " + quoted(head) + " for " + channel + ", expected one of " + heads);
    }
    for (const auto* choices : {&options_.units, &options_.sensitivities})
      for (const auto& [channel, text] : *choices)
        if (!is_time_choice(channel)) require_channel(full_name(channel));
  }

  // A rig without DOFs knows no channel: then the name alone decides.
  void require_channel(const std::string& name) const {
    const bool no_rig = model_.dofs.empty();
    const std::string fault = no_rig && rig_file::parse_channel_name(name) ? "" : channel_name_fault(name, model_);
    if (!fault.empty()) refuse("channel " + quoted(name) + ": " + fault);
  }

  void use(const std::vector<Column>& columns, size_t i) {
    const HeadParts head = split_head(columns[i].head);
    const std::string& unit = columns[i].unit.empty() ? head.unit : columns[i].unit;
    for (const auto& [channel, text] : options_.columns)
      if (!text.empty() && is_head(columns, i, text)) {
        if (is_time_choice(channel)) {
          time_column_ = i;
        } else {
          take(i, columns[i], *rig_file::parse_channel_name(full_name(channel)), unit, true);
        }
        return;
      }
    for (const rig_file::ChannelEntry& entry : model_.channels)
      if (!entry.column.empty() && is_head(columns, i, entry.column)) {
        const ChannelName channel = *rig_file::parse_channel_name(entry.name);
        if (!is_left_out(channel)) take(i, columns[i], channel, unit, true);
        return;
      }
    if (const auto channel = rig_file::parse_channel_name(head.name)) {
      const Dimension dimension = dimension_of(channel->quantity, channel->rotating);
      require_channel(head.name);
      own_names_ = true;
      if (is_left_out(*channel)) return;
      if (const auto said = find_unit(unit, dimension); said && said->to_si != 1.0)
        refuse("column " + quoted(head.name) + " has the unit " + quoted(unit) + ", expected " + si_unit(dimension) +
               " as its name says, or a name that ends on the unit, as in displacement_1_mm");
      return take(i, columns[i], *channel, si_unit(dimension), false);
    }
    if (const auto loose = parse_loose_name(head.name)) return take_loose(i, columns[i], *loose, unit);
    std::string suffix;
    if (is_time_name(head.name, suffix)) return;
    if (shaped_like_channel(head.name)) require_channel(head.name);  // and says what was expected
  }

  bool is_taken(const ChannelName& channel) const {
    return std::any_of(plan_.uses.begin(), plan_.uses.end(), [&](const ColumnUse& use) {
      return use.kind == ColumnUse::Kind::kChannel && use.channel.name == rig_file::format_channel_name(channel);
    });
  }

  // The user wants it left out: --column velocity_1=
  bool is_left_out(const ChannelName& channel) const {
    return std::any_of(options_.columns.begin(), options_.columns.end(), [&](const auto& choice) {
      return choice.second.empty() && full_name(choice.first) == rig_file::format_channel_name(channel);
    });
  }

  // A rig of one DOF, or none known, and a file whose names are no channels': "Position (m)" is the only displacement there is,
  // where the user said of no other column that it is it. A word without a unit, or one that stands twice, says too little.
  void take_plain(const std::vector<Column>& columns) {
    std::vector<std::optional<PlainName>> plain;
    for (const Column& column : columns) {
      const HeadParts head = split_head(column.head);
      plain.push_back(parse_plain_name(head.name, column.unit.empty() ? head.unit : column.unit));
      const bool other_kind =
          plain.back() && !model_.dofs.empty() && plain.back()->channel.rotating != model_.dofs[0].rotating;
      if (other_kind || (plain.back() && plain.back()->unit.empty())) plain.back().reset();
    }
    for (size_t i = 0; i < columns.size(); ++i) {
      if (!plain[i] || plan_.uses[i].kind == ColumnUse::Kind::kChannel || is_taken(plain[i]->channel) ||
          is_left_out(plain[i]->channel))
        continue;
      const auto same = std::count_if(plain.begin(), plain.end(), [&](const std::optional<PlainName>& p) {
        return p && p->channel.quantity == plain[i]->channel.quantity &&
               p->channel.rotating == plain[i]->channel.rotating;
      });
      if (same == 1) take(i, columns[i], plain[i]->channel, plain[i]->unit, true);
    }
  }

  // "displacement_1_mm", or "displacement_1" with a unit elsewhere.
  void take_loose(size_t i, const Column& column, const NamedChannel& loose, const std::string& unit) {
    own_names_ = true;
    if (is_left_out(loose.channel)) return;
    const std::string name = rig_file::format_channel_name(loose.channel);
    const Dimension dimension = dimension_of(loose.channel.quantity, loose.channel.rotating);
    if (!loose.suffix.empty()) {
      const auto suffix = find_unit_suffix(loose.suffix, dimension);
      if (!suffix) require_channel(split_head(column.head).name);  // no channel name: says so
      return take(i, column, loose.channel, suffix->word, false);
    }
    if (unit.empty() && chosen(options_.units, model_, name, &rig_file::ChannelEntry::unit).empty())
      refuse("column " + quoted(trimmed_text(column.head)) + " has no unit; did you mean " + quoted(name) +
             "? Expected the unit in the name, in brackets, in a row of units or as --unit");
    take(i, column, loose.channel, unit, false);
  }

  void take(size_t i, const Column& column, const ChannelName& channel, const std::string& file_unit, bool mapped) {
    const std::string name = rig_file::format_channel_name(channel);
    require_channel(name);
    ColumnUse& use = plan_.uses[i];
    for (const ColumnUse& earlier : plan_.uses)
      if (earlier.kind == ColumnUse::Kind::kChannel && earlier.channel.name == name)
        refuse("column " + quoted(trimmed_text(column.head)) + " is " + name +
               ", which stands twice, expected each channel once");
    use.kind = ColumnUse::Kind::kChannel;
    use.channel.name = name;
    use.channel.quantity = static_cast<Quantity>(channel.quantity);
    use.channel.dof = channel.dof;
    std::string unit = chosen(options_.units, model_, name, &rig_file::ChannelEntry::unit);
    if (unit.empty()) unit = file_unit;
    convert(use, column, dimension_of(channel.quantity, channel.rotating), unit, mapped);
  }

  void convert(ColumnUse& use, const Column& column, Dimension wanted, const std::string& unit, bool mapped) {
    const std::string& name = use.channel.name;
    const std::string from =
        trimmed_text(column.head) == name ? "" : " from column " + quoted(trimmed_text(column.head));
    const std::string sensor = chosen(options_.sensitivities, model_, name, &rig_file::ChannelEntry::sensitivity);
    if (unit.empty() && sensor.empty()) {
      if (mapped) plan_.notes.push_back(name + from + ": no unit is given, taken as " + si_unit(wanted));
      return;
    }
    if (!sensor.empty() && !parse_sensitivity(sensor))
      refuse(name + ": " + quoted(sensor) + " is no sensitivity, expected one such as \"100 mV/" + si_unit(wanted) +
             "\"");
    const auto found = find_scaled_unit(unit.empty() ? "V" : unit, wanted);
    if (!found)
      refuse("column " + quoted(trimmed_text(column.head)) + " is in " + quoted(unit) +
             ", which is no known unit; expected " + si_unit(wanted) + " or the like, or --unit");
    std::string how = " in " + found->word;
    if (found->dimension == Dimension::kVoltage && wanted != Dimension::kVoltage) {
      const auto sensitivity = parse_sensitivity(sensor);
      if (!sensitivity || sensitivity->dimension != wanted)
        refuse("column " + quoted(trimmed_text(column.head)) +
               " is a voltage; expected its sensor's sensitivity, as in --sensitivity " +
               name.substr(0, name.find('_', name.find('_') + 1)) + "=\"100 mV/" + si_unit(wanted) + "\"" +
               (sensor.empty() ? "" : ", found " + quoted(sensor)));
      use.factor = found->to_si / sensitivity->volts_per_si;
      how += " at " + sensor;
    } else if (found->dimension != wanted) {
      refuse("column " + quoted(trimmed_text(column.head)) + " is in " + found->word + ", expected a unit such as " +
             si_unit(wanted) + " for " + name);
    } else {
      use.factor = found->to_si;
      if (!sensor.empty()) how += " (no voltage: its sensitivity of " + sensor + " is not used)";
    }
    if (use.factor != 1.0) {
      plan_.notes.push_back(name + from + how + ": values times " + number(use.factor));
    } else if (!from.empty() || !sensor.empty()) {
      plan_.notes.push_back(name + from + how);
    }
  }

  void take_time(const std::vector<Column>& columns) {
    std::string suffix;
    size_t found = time_column_;
    for (size_t i = 0; found == kNone && i < columns.size(); ++i)
      if (split_head(columns[i].head).name == "t_s") found = i;
    for (size_t i = 0; found == kNone && i < columns.size(); ++i)
      if (plan_.uses[i].kind == ColumnUse::Kind::kIgnored && is_time_name(split_head(columns[i].head).name, suffix))
        found = i;
    if (found == kNone || options_.sample_rate_Hz > 0.0) return;
    ColumnUse& time = plan_.uses[found];
    time.kind = ColumnUse::Kind::kTime;
    const HeadParts head = split_head(columns[found].head);
    is_time_name(head.name, suffix);
    std::string unit = suffix;
    for (const auto& [name, text] : options_.units)
      if (is_time_choice(name)) unit = text;
    if (unit.empty()) unit = columns[found].unit.empty() ? head.unit : columns[found].unit;
    if (unit.empty()) unit = "s";
    const auto known = find_scaled_unit(unit, Dimension::kTime);
    if (!known || known->dimension != Dimension::kTime)
      refuse("column " + quoted(head.name) + " is in " + quoted(unit) + ", expected a unit of time such as s or ms");
    time.factor = known->to_si;
    if (time.factor != 1.0)
      plan_.notes.push_back("time from column " + quoted(trimmed_text(columns[found].head)) + " in " + known->word +
                            ": values times " + number(time.factor));
  }

  void note_ignored(const std::vector<Column>& columns) {
    std::string heads;
    for (size_t i = 0; i < columns.size(); ++i)
      if (plan_.uses[i].kind == ColumnUse::Kind::kIgnored && !trimmed_text(columns[i].head).empty())
        heads += (heads.empty() ? "" : ", ") + quoted(trimmed_text(columns[i].head));
    if (!heads.empty()) plan_.notes.push_back("ignored: " + heads);
    note_unread_force(columns);
  }

  // A file with columns in units of force of which none is read: what drives the rig is likely among them.
  void note_unread_force(const std::vector<Column>& columns) {
    const bool reads = std::any_of(plan_.uses.begin(), plan_.uses.end(), [](const ColumnUse& use) {
      return use.kind == ColumnUse::Kind::kChannel && use.channel.quantity == Quantity::kForce;
    });
    for (size_t i = 0; i < columns.size() && !reads; ++i) {
      if (plan_.uses[i].kind != ColumnUse::Kind::kIgnored || !in_force(columns[i])) continue;
      const bool turns = !model_.dofs.empty() && model_.dofs.front().rotating;
      plan_.notes.push_back("no force is read, and " + quoted(trimmed_text(columns[i].head)) +
                            " is in a unit of force; if it drives the rig: --column " +
                            (turns ? "torque_1=" : "force_1=") + quoted(trimmed_text(columns[i].head)));
      return;
    }
  }

  static bool in_force(const Column& column) {
    const HeadParts head = split_head(column.head);
    const std::string unit = column.unit.empty() ? head.unit : column.unit;
    for (const Dimension dimension : {Dimension::kForce, Dimension::kTorque}) {
      const auto known = unit.empty() ? std::nullopt : find_unit(unit, dimension);
      if (known && known->dimension == dimension) return true;
    }
    return false;
  }

  static constexpr size_t kNone = static_cast<size_t>(-1);
  const rig_file::RigModel& model_;
  const ReadingOptions& options_;
  const std::string& file_;
  size_t line_;
  size_t time_column_ = kNone;
  bool own_names_ = false;  // the file names channels as the rig does
  ColumnPlan plan_;
};

}  // namespace

bool ColumnPlan::has_time() const {
  return std::any_of(uses.begin(), uses.end(), [](const ColumnUse& use) { return use.kind == ColumnUse::Kind::kTime; });
}

ColumnPlan plan_columns(const std::vector<Column>& columns, const rig_file::RigModel& model,
                        const ReadingOptions& options, const std::string& file, size_t line) {
  return Planner(model, options, file, line).plan(columns);
}

bool means_channel(const std::string& head, const rig_file::RigModel& model, const ReadingOptions& options) {
  const HeadParts parts = split_head(head);
  const auto is = [&](const std::string& text) {
    if (text.find_first_not_of("0123456789") == std::string::npos) return false;  // a place in a table without names
    return (text == parts.name || text == trimmed_text(head));
  };
  for (const auto& [channel, text] : options.columns)
    if (!text.empty() && is(trimmed_text(text))) return true;
  for (const rig_file::ChannelEntry& entry : model.channels)
    if (is(trimmed_text(entry.column))) return true;
  const auto plain = parse_plain_name(parts.name, parts.unit);
  if (model.dofs.size() <= 1 && plain && !plain->unit.empty()) return true;
  return parts.name == "t_s" || shaped_like_channel(parts.name);
}

std::string plain_name_hint(const std::vector<Column>& columns, const rig_file::RigModel& model) {
  std::string hint;
  for (const Column& column : columns) {
    const HeadParts head = split_head(column.head);
    auto plain = parse_plain_name(head.name, "");
    if (!plain) plain = parse_plain_name(head.name.substr(0, head.name.find(' ')), "");  // "Acceleration a_x"
    if (!plain || model.dofs.size() > 1) continue;
    rig_file::ChannelName channel = plain->channel;
    if (!model.dofs.empty()) channel.rotating = model.dofs[0].rotating;
    const std::string name = rig_file::format_channel_name(channel), dof = "_1";
    const std::string option = "--column " + name.substr(0, name.find(dof) + dof.size()) + "=";
    if (hint.find(option) != std::string::npos) continue;  // a quantity twice: the first of its columns
    hint += (hint.empty() ? "" : " ") + option + "\"" + trimmed_text(column.head) + "\"";
  }
  if (!hint.empty()) return hint;
  return !model.dofs.empty() && model.dofs[0].rotating ? "--column angle_1=NAME" : "--column displacement_1=NAME";
}

}  // namespace host_sim
