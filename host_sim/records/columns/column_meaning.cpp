#include "host_sim/records/columns/column_meaning.hpp"

#include <algorithm>
#include <optional>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/records/columns/names/column_name.hpp"
#include "host_sim/records/columns/names/plain_name.hpp"
#include "host_sim/records/columns/plan/column_choices.hpp"
#include "host_sim/records/columns/plan/column_context.hpp"
#include "host_sim/records/columns/plan/column_factor.hpp"
#include "host_sim/records/columns/plan/ignored_columns.hpp"
#include "host_sim/records/columns/plan/time_column.hpp"
#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {
namespace {

using rig_file::ChannelName;

class Planner {
 public:
  Planner(const rig_file::RigModel& model, const ReadingOptions& options, const std::string& file, size_t line)
      : context_{model, options, file, line} {}

  ColumnPlan plan(const std::vector<Column>& columns) {
    plan_.uses.resize(columns.size());
    check_choices(context_, columns);
    for (size_t i = 0; i < columns.size(); ++i) use(columns, i);
    if (context_.model.dofs.size() <= 1 && !own_names_) take_plain(columns);
    take_time(context_, columns, time_column_, plan_);
    note_ignored(context_.model, columns, plan_);
    return std::move(plan_);
  }

 private:
  void use(const std::vector<Column>& columns, size_t i) {
    const HeadParts head = parts_of(columns[i]);
    const std::string& unit = head.unit;
    for (const auto& [channel, text] : context_.options.columns)
      if (!text.empty() && is_head(columns, i, text)) {
        if (is_time_choice(channel)) {
          time_column_ = i;
        } else {
          take(i, columns[i], *rig_file::parse_channel_name(full_name(channel)), unit, true);
        }
        return;
      }
    for (const rig_file::ChannelEntry& entry : context_.model.channels)
      if (!entry.column.empty() && is_head(columns, i, entry.column)) {
        const ChannelName channel = *rig_file::parse_channel_name(entry.name);
        if (!is_left_out(channel, context_.options)) take(i, columns[i], channel, unit, true);
        return;
      }
    if (const auto channel = rig_file::parse_channel_name(head.name)) {
      const Dimension dimension = dimension_of(channel->quantity, channel->rotating);
      context_.require_channel(head.name);
      own_names_ = true;
      if (is_left_out(*channel, context_.options)) return;
      if (const auto said = find_unit(unit, dimension); said && said->to_si != 1.0)
        context_.refuse("column " + quoted(head.name) + " has the unit " + quoted(unit) + ", expected " +
                        si_unit(dimension) +
                        " as its name says, or a name that ends on the unit, as in displacement_1_mm");
      return take(i, columns[i], *channel, si_unit(dimension), false);
    }
    if (const auto loose = parse_loose_name(head.name)) return take_loose(i, columns[i], *loose, unit);
    std::string suffix;
    if (is_time_name(head.name, suffix)) return;
    if (shaped_like_channel(head.name)) context_.require_channel(head.name);  // and says what was expected
  }

  bool is_taken(const ChannelName& channel) const {
    return std::any_of(plan_.uses.begin(), plan_.uses.end(), [&](const ColumnUse& use) {
      return use.kind == ColumnUse::Kind::kChannel && use.channel.name == rig_file::format_channel_name(channel);
    });
  }

  // A rig of one DOF, or none known, and a file whose names are no channels': "Position (m)" is the only displacement there is,
  // where the user said of no other column that it is it. A word without a unit, or one that stands twice, says too little.
  void take_plain(const std::vector<Column>& columns) {
    std::vector<std::optional<PlainName>> plain;
    for (const Column& column : columns) {
      const HeadParts head = parts_of(column);
      plain.push_back(parse_plain_name(head.name, head.unit));
      const bool other_kind = plain.back() && !context_.model.dofs.empty() &&
                              plain.back()->channel.rotating != context_.model.dofs[0].rotating;
      if (other_kind || (plain.back() && plain.back()->unit.empty())) plain.back().reset();
    }
    for (size_t i = 0; i < columns.size(); ++i) {
      if (!plain[i] || plan_.uses[i].kind == ColumnUse::Kind::kChannel || is_taken(plain[i]->channel) ||
          is_left_out(plain[i]->channel, context_.options))
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
    if (is_left_out(loose.channel, context_.options)) return;
    const std::string name = rig_file::format_channel_name(loose.channel);
    const Dimension dimension = dimension_of(loose.channel.quantity, loose.channel.rotating);
    if (!loose.suffix.empty()) {
      const auto suffix = find_unit_suffix(loose.suffix, dimension);
      if (!suffix) context_.require_channel(split_head(column.head).name);  // no channel name: says so
      return take(i, column, loose.channel, suffix->word, false);
    }
    if (unit.empty() && chosen(context_.options.units, context_.model, name, &rig_file::ChannelEntry::unit).empty())
      context_.refuse("column " + quoted_head(column) + " has no unit; did you mean " + quoted(name) +
                      "? Expected the unit in the name, in brackets, in a row of units or as --unit");
    take(i, column, loose.channel, unit, false);
  }

  void take(size_t i, const Column& column, const ChannelName& channel, const std::string& file_unit, bool mapped) {
    const std::string name = rig_file::format_channel_name(channel);
    context_.require_channel(name);
    ColumnUse& use = plan_.uses[i];
    for (const ColumnUse& earlier : plan_.uses)
      if (earlier.kind == ColumnUse::Kind::kChannel && earlier.channel.name == name)
        context_.refuse("column " + quoted_head(column) + " is " + name +
                        ", which stands twice, expected each channel once");
    use.kind = ColumnUse::Kind::kChannel;
    use.channel.name = name;
    use.channel.quantity = static_cast<Quantity>(channel.quantity);
    use.channel.dof = channel.dof;
    std::string unit = chosen(context_.options.units, context_.model, name, &rig_file::ChannelEntry::unit);
    if (unit.empty()) unit = file_unit;
    find_factor(context_, column, {dimension_of(channel.quantity, channel.rotating), unit, mapped}, use, plan_.notes);
  }

  ColumnContext context_;
  std::optional<size_t> time_column_;  // that the user chose
  bool own_names_ = false;             // the file names channels as the rig does
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

}  // namespace host_sim
