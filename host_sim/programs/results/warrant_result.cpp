#include "host_sim/programs/results/warrant_result.hpp"

#include <fmt/format.h>

#include <cmath>

#include "firmware/vocabulary/effect_table.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/scaled_double.hpp"

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
  result.rival = finding_of(model, warrant.rival);
  result.rival_percent = 100.0 * rig_file::to_double(warrant.rival_share);
  return result;
}

std::string after_suspicion(const WarrantResult& warrant) {
  if (warrant.named.effect.empty() || warrant.explained) return "";
  return "what to do: host_sim diagnose asks the same data whether that is it; --extended-rig FILE writes a rig file "
         "that has it, "
         "for the next estimate";
}

std::string warrant_text(const WarrantResult& warrant) {
  if (warrant.named.effect.empty())
    return warrant.tested ? "the board finds nothing that the rig file lacks"
                          : "the board cannot test the rig file with these data";
  std::string size = fmt::format(", {:.4g} +- {:.2g}", warrant.named.size, warrant.named.std);
  std::string text = "the board suspects " + warrant.named.effect + " on " + warrant.named.where + size +
                     (warrant.named.unit.empty() ? "" : " ") + warrant.named.unit + slip_text(warrant.named);
  if (warrant.explained) return text + ": corrected, and nothing else is found";
  if (warrant.rival.effect.empty()) return text;
  std::string share = fmt::format(" ({:.0f} % of its likelihood)", warrant.rival_percent);
  return text + "; next best " + warrant.rival.effect + " on " + warrant.rival.where + share;
}

}  // namespace host_sim
