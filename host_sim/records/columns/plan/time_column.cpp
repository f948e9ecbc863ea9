#include "host_sim/records/columns/plan/time_column.hpp"

#include "host_sim/records/columns/plan/column_choices.hpp"
#include "host_sim/records/columns/plan/column_factor.hpp"
#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {
namespace {

std::optional<size_t> column_of_time(const std::vector<Column>& columns, const ColumnPlan& plan) {
  for (size_t i = 0; i < columns.size(); ++i)
    if (split_head(columns[i].head).name == "t_s") return i;
  std::string suffix;
  for (size_t i = 0; i < columns.size(); ++i)
    if (plan.uses[i].kind == ColumnUse::Kind::kIgnored && is_time_name(split_head(columns[i].head).name, suffix))
      return i;
  return std::nullopt;
}

// "hh:mm:ss", "[h:mm:ss.f]", "dd.mm.yyyy hh:mm": how a clock is written, which the rows tell by themselves.
bool says_clock(const std::string& unit) {
  return unit.find(':') != std::string::npos &&
         unit.find_first_not_of("YyJjMmDdTtHhSsFfXx0:.,'/- ()[]") == std::string::npos;
}

}  // namespace

void take_time(const ColumnContext& context, const std::vector<Column>& columns, std::optional<size_t> chosen,
               ColumnPlan& plan) {
  const std::optional<size_t> found = chosen ? chosen : column_of_time(columns, plan);
  if (!found || context.options.sample_rate_Hz > 0.0) return;
  ColumnUse& time = plan.uses[*found];
  time.kind = ColumnUse::Kind::kTime;
  const HeadParts head = parts_of(columns[*found]);
  std::string suffix;
  is_time_name(head.name, suffix);
  std::string unit = suffix;
  for (const auto& [name, text] : context.options.units)
    if (is_time_choice(name)) unit = text;
  if (unit.empty()) unit = head.unit;
  if (unit.empty() || says_clock(unit)) unit = "s";
  const auto known = find_scaled_unit(unit, Dimension::kTime);
  if (!known || known->dimension != Dimension::kTime)
    context.refuse("column " + quoted(head.name) + " is in " + quoted(unit) +
                   ", expected a unit of time such as s or ms");
  time.factor = known->to_si;
  if (time.factor != 1.0)
    plan.notes.push_back("time from column " + quoted_head(columns[*found]) + " in " + known->word +
                         said_factor(time.factor));
}

}  // namespace host_sim
