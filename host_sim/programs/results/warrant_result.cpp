#include "host_sim/programs/results/warrant_result.hpp"

#include <fmt/format.h>

#include <cmath>

#include "firmware/vocabulary/effect_table.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "host_sim/vocabulary/said.hpp"

namespace host_sim {
namespace {

// A fault of a channel that is no row of the vocabulary; nullptr: it is one.
const char* fault_word(firmware::Cause cause) {
  if (cause == firmware::Cause::kPolarity) return "polarity";
  return cause == firmware::Cause::kUnit ? "unit" : nullptr;
}

const firmware::EffectRow* row_of_cause(firmware::Cause cause) {
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    if (row.can.number != 0 && row.can.number == static_cast<uint8_t>(cause)) return &row;
  return nullptr;
}

int dof_of(int node) {
  if (node == firmware::kBaseNode) return rig_file::kBase;
  return node == firmware::kGroundNode ? rig_file::kGround : node + 1;
}
std::string place(int node) {
  const int dof = dof_of(node);
  return dof == rig_file::kBase ? "base" : std::to_string(dof);
}

FindingResult finding_of(const rig_file::RigModel& model, const firmware::Finding& finding) {
  FindingResult result;
  const firmware::EffectRow* row = row_of_cause(finding.cause);
  const char* const fault = fault_word(finding.cause);
  if ((row == nullptr && fault == nullptr) || finding.node_a < 0) return result;
  const int dof = dof_of(finding.node_a);
  const bool rotating = dof > 0 && model.dofs[static_cast<size_t>(dof - 1)].rotating;
  result.effect = fault != nullptr ? fault : row->word.text;
  if (finding.quantity != firmware::kNoQuantity)
    result.where =
        "channel " + rig_file::format_channel_name({static_cast<firmware::Quantity>(finding.quantity), dof, rotating});
  else if (finding.node_b >= 0)
    result.where = "link " + place(finding.node_a) + "-" + place(finding.node_b);
  else
    result.where = "dof " + place(finding.node_a);
  result.size = rig_file::to_double(finding.size);
  result.std = rig_file::to_double(finding.std);
  const char* unit = fault != nullptr ? nullptr : row->unit.of(rotating);
  result.unit = unit == nullptr || std::string(unit) == "1" ? "" : unit;
  return result;
}

// A gain that is no gain: what such a factor usually is.
std::string slip_text(const FindingResult& named) {
  if (named.effect != "polarity" && named.effect != "unit") return "";
  struct Slip {
    double gain;
    const char* text;
  };
  for (const Slip& slip :
       {Slip{-1, "its sign is reversed"}, Slip{1e3, "a unit slip, a factor of 1000"},
        Slip{1e-3, "a unit slip, a factor of 1/1000"}, Slip{9.80665, "a unit slip, a factor of 9.81"},
        Slip{1 / 9.80665, "a unit slip, a factor of 1/9.81"}})
    if (std::abs(1 + named.size - slip.gain) < 0.5 * std::abs(slip.gain))
      return std::string("; it looks like ") + slip.text;
  return "";
}

}  // namespace

WarrantResult warrant_of(const rig_file::RigModel& model, const firmware::Warrant& warrant) {
  WarrantResult result;
  result.tested = warrant.tested;
  result.named = finding_of(model, warrant.named);
  result.explained = warrant.corrected;
  if (warrant.corrected) result.corrected.push_back(result.named);
  result.naming = warrant.naming;
  result.explains_percent = 100.0 * rig_file::to_double(warrant.gained);
  result.rival = finding_of(model, warrant.rival);
  result.rival_percent = 100.0 * rig_file::to_double(warrant.rival_share);
  return result;
}

bool suspects(const WarrantResult& warrant) { return !warrant.named.effect.empty() && !warrant.explained; }

std::string why_not_the_cause(const WarrantResult& warrant) {
  constexpr double kMeasured = 2.0;  // standard deviations
  switch (warrant.naming) {
    case firmware::Naming::kExplains:
      return std::fabs(warrant.named.size) < kMeasured * warrant.named.std ? "its size may as well be nought" : "";
    case firmware::Naming::kInPart:
      return "it leaves more than noise";
    case firmware::Naming::kOutdone:
      return "another force stands out more";
    case firmware::Naming::kTakenUp:
      return "the estimated coefficients take up most of it, and the rest is what integration makes of slow noise: "
             "measure "
             "the displacement as well, or leave out what is at rest";
    case firmware::Naming::kNoFault:
      return warrant.named.where.rfind("channel ", 0) == 0
                 ? "no channel that is measured can be off like that"
                 : "no rig has a force like that: it would push, or be less than nothing";
  }
  return "";
}

std::string after_suspicion(const WarrantResult& warrant) {
  if (!suspects(warrant)) return "";
  const std::string file = "--extended-rig FILE writes a rig file that has it, for the next estimate";
  if (!why_not_the_cause(warrant).empty())
    return "host_sim diagnose looks for it in the same data, with more candidates and two at a time; " + file;
  return "host_sim diagnose asks the same data whether that is it; " + file;
}

namespace {

std::string finding_text(const WarrantResult& warrant) {
  const FindingResult& named = warrant.named;
  std::string text = vocabulary::said(named.effect, named.where) +
                     fmt::format(", {:.4g} +- {:.2g}", named.size, named.std) + (named.unit.empty() ? "" : " ") +
                     named.unit + slip_text(named);
  const bool told_apart = warrant.naming != firmware::Naming::kTakenUp && warrant.naming != firmware::Naming::kNoFault;
  if (warrant.explained || !told_apart || warrant.explains_percent == 0.0) return text;
  return text + fmt::format(", takes away {:.0f} % of what does not fit there", warrant.explains_percent);
}

}  // namespace

std::string warrant_text(const WarrantResult& warrant) {
  if (warrant.named.effect.empty())
    return warrant.tested ? "the board finds nothing that the rig file lacks"
                          : "the board cannot test the rig file with these data";
  const bool is_cause = why_not_the_cause(warrant).empty();
  std::string text =
      is_cause ? "the board suspects " + finding_text(warrant)
               : "the rig file lacks something that none of the board's candidates explains alone (nearest: " +
                     finding_text(warrant) + ", but " + why_not_the_cause(warrant);
  if (warrant.explained) return text + ": corrected, and nothing else is found";
  if (!warrant.rival.effect.empty()) {
    text += "; next " + std::string(is_cause ? "best " : "nearest ") +
            vocabulary::said(warrant.rival.effect, warrant.rival.where);
    if (is_cause) text += fmt::format(" ({:.0f} % of its likelihood)", warrant.rival_percent);
  }
  return text + (is_cause ? "" : ")");
}

}  // namespace host_sim
