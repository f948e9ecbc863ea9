#include "hal/rig_file/compile_rig.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/coefficient_walk.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {
namespace {

[[noreturn]] void refuse(const RigModel& model, const std::string& key, const std::string& problem) {
  throw RigFileError(model.file.empty() ? "rig" : model.file, 0, key, problem);
}

void check_capacity(const RigModel& model, int unknowns, const std::vector<firmware::Term>& terms) {
  const auto check = [&](size_t count, int most, const char* what) {
    if (count > static_cast<size_t>(most))
      refuse(model, what, std::to_string(count) + " of them, expected at most " + std::to_string(most));
  };
  check(model.dofs.size(), firmware::kMaxDofs, "DOFs");
  check(model.links.size(), firmware::kMaxLinks, "links");
  check(static_cast<size_t>(unknowns), firmware::kMaxUnknowns, "coefficients to estimate");
  check(terms.size(), firmware::kMaxTerms, "coefficients");
  const auto effect = [](const firmware::Term& term) { return firmware::is_effect_term(term.kind); };
  check(static_cast<size_t>(std::count_if(terms.begin(), terms.end(), effect)), firmware::kMaxEffectColumns,
        "effects on links");
}

std::vector<firmware::Term> compile_terms(const RigModel& model, int& unknowns) {
  std::vector<firmware::Term> terms;
  unknowns = 0;
  walk_coefficients(model, [&](const CoefficientSite& site, const Coefficient& coefficient) {
    if (!site.in_core && coefficient.estimate)
      refuse(model, site.name, "cannot be estimated by the core, expected a number");
    if (!site.in_core || (!coefficient.estimate && coefficient.value == 0.0)) return;
    firmware::Term term;
    term.kind = site.kind();
    term.place = static_cast<uint8_t>(site.place);
    term.shape = to_scaled(site.shape);
    term.second_shape_q26 = static_cast<int32_t>(std::lround(std::ldexp(site.second_shape, 26)));
    if (coefficient.estimate)
      term.unknown = static_cast<int8_t>(std::min(unknowns++, 127));
    else
      term.value = to_scaled(coefficient.value);
    terms.push_back(term);
  });
  return terms;
}

void compile_channel(const RigModel& model, const ChannelCalibration& channel, firmware::CoreConfiguration& result) {
  if (channel.dof != kBase && (channel.dof < 1 || channel.dof > static_cast<int>(model.dofs.size())))
    refuse(model, "channel of DOF " + std::to_string(channel.dof),
           "the rig has no such DOF, expected 1 to " + std::to_string(model.dofs.size()));
  firmware::ChannelConfiguration& target = result.channels[node_index(channel.dof)][static_cast<int>(channel.quantity)];
  target.present = true;
  target.offset_code = channel.offset_code;
  target.lowest_code = channel.lowest_code;
  target.highest_code = channel.highest_code;
  target.unit_per_code = to_scaled(channel.unit_per_code);
  target.delay_ns = static_cast<int32_t>(std::lround(channel.delay_s * 1e9));
  if (channel.dof == kBase) result.base_present = true;
}

}  // namespace

void ChannelCalibration::take(const ChannelEntry& entry) {
  if (entry.unit_per_code != 0.0) unit_per_code = entry.unit_per_code;
  offset_code = entry.offset_code;
  delay_s = entry.delay_us * 1e-6;
  if (entry.lowest_code == entry.highest_code) return;
  lowest_code = entry.lowest_code;
  highest_code = entry.highest_code;
}

int node_index(int dof) {
  if (dof == kBase) return firmware::kBaseNode;
  return dof == kGround ? firmware::kGroundNode : dof - 1;
}

firmware::CoreConfiguration compile_rig(const RigModel& model, double sample_period_s,
                                        const std::vector<ChannelCalibration>& channels) {
  int unknowns = 0;
  const std::vector<firmware::Term> terms = compile_terms(model, unknowns);
  check_capacity(model, unknowns, terms);
  firmware::CoreConfiguration result;
  result.dof_count = static_cast<uint8_t>(model.dofs.size());
  result.link_count = static_cast<uint8_t>(model.links.size());
  result.term_count = static_cast<uint8_t>(terms.size());
  result.unknown_count = static_cast<uint8_t>(unknowns);
  result.sample_period_s = to_scaled(sample_period_s);
  for (size_t i = 0; i < model.links.size(); ++i) {
    result.links[i].node_a = static_cast<uint8_t>(node_index(model.links[i].a));
    result.links[i].node_b = static_cast<uint8_t>(node_index(model.links[i].b));
  }
  for (size_t i = 0; i < terms.size(); ++i) result.terms[i] = terms[i];
  for (const ChannelCalibration& channel : channels) compile_channel(model, channel, result);
  if (channels.empty())
    firmware::copy_measured_signals(result);
  else
    plan_signals(result);
  return result;
}

std::vector<ParameterInfo> parameter_table(const RigModel& model) {
  std::vector<ParameterInfo> table;
  walk_coefficients(model, [&](const CoefficientSite& site, const Coefficient& coefficient) {
    if (site.in_core && coefficient.estimate)
      table.push_back({site.name, site.unit, site.kind(), site.dof_term, site.place});
  });
  return table;
}

std::vector<std::string> parameter_names(const RigModel& model) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : parameter_table(model)) names.push_back(info.name);
  return names;
}

RigModel with_values(const RigModel& model, const std::vector<double>& values) {
  RigModel result = model;
  size_t next = 0;
  walk_coefficients(result, [&](const CoefficientSite& site, Coefficient& coefficient) {
    if (!site.in_core || !coefficient.estimate) return;
    coefficient.value = values.at(next++);
    coefficient.estimate = false;
  });
  return result;
}

std::vector<std::string> simulator_only_effects(const RigModel& model) {
  std::vector<std::string> names;
  walk_coefficients(model, [&](const CoefficientSite& site, const Coefficient&) {
    if (!site.in_core) names.push_back(site.name);
  });
  return names;
}

}  // namespace rig_file
