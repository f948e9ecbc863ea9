#include "hal/rig_file/toml/rig_reader.hpp"

#include <algorithm>
#include <set>

#include "firmware/configuration/capacity.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/effect_reader.hpp"
#include "hal/rig_file/toml/effect_words.hpp"
#include "hal/rig_file/toml/rig_from_toml.hpp"
#include "hal/rig_file/toml/toml_checks.hpp"

namespace rig_file {
namespace {

using firmware::EffectKind;

struct LinkKey {
  EffectKind kind;
  Coefficient Link::*field;
  const firmware::EffectRow& row() const { return firmware::row_of(kind); }
  bool may_be_negative() const { return row().sign == firmware::Sign::kAny; }
};
constexpr LinkKey kLinkKeys[] = {{EffectKind::kStiffness, &Link::stiffness_N_m},
                                 {EffectKind::kViscous, &Link::viscous_N_s_m},
                                 {EffectKind::kCoulomb, &Link::coulomb_N},
                                 {EffectKind::kGravityTorque, &Link::gravity_torque_N_m}};

Dof read_dof(const Place& place, const toml::table& table) {
  Dof dof;
  const std::string mass_key = own_key(firmware::row_of(EffectKind::kMass), false);
  const std::string inertia_key = own_key(firmware::row_of(EffectKind::kMass), true);
  const toml::node* mass = table.get(mass_key);
  const toml::node* inertia = table.get(inertia_key);
  require_known_keys(place, table, {mass_key, inertia_key, "effect"});
  if (mass != nullptr && inertia != nullptr)
    refuse(place, *inertia, inertia_key,
           "stands beside " + mass_key + ", expected one of them: a DOF translates or rotates");
  if (mass == nullptr && inertia == nullptr)
    refuse(
        place, table, mass_key,
        "is missing, expected " + mass_key + " (or " + inertia_key + " for a rotating DOF): a number or \"estimate\"");
  dof.rotating = inertia != nullptr;
  dof.mass_kg = read_coefficient(place, dof.rotating ? *inertia : *mass, dof.rotating ? inertia_key : mass_key, false);
  dof.effects = read_effects(place, table, EffectPlace::kDof, dof.rotating);
  return dof;
}

int read_link_end(const Place& place, const toml::node& node, int dof_count, bool first) {
  if (node.is_string() && node.value_or(std::string()) == "base" && !first) return kBase;
  const auto number = node.value_exact<int64_t>();
  if (number && *number == kGround && !first) return kGround;
  if (number && *number >= 1 && *number <= dof_count) return static_cast<int>(*number);
  const std::string range = "1 to " + std::to_string(dof_count);
  const std::string found =
      number ? "names DOF " + std::to_string(*number) + ", which the file does not have" : "is not a DOF number";
  refuse(place, node, "between",
         first ? (number && *number == kGround ? std::string("starts with the ground") : found) +
                     ", expected a DOF number first (" + range + "), then a DOF number, 0 for the ground or \"base\""
               : found + ", expected " + range + ", 0 for the ground or \"base\"");
}

void read_ends(const Place& place, const toml::table& table, const std::vector<Dof>& dofs, Link& link) {
  const toml::node* between = table.get("between");
  if (between == nullptr)
    refuse(place, table, "between", "is missing, expected between = [1, 0] (two DOF numbers; 0 is the ground)");
  const toml::array* ends = between->as_array();
  if (ends == nullptr || ends->size() != 2)
    refuse(place, *between, "between", "is not a pair, expected between = [1, 0] (two DOF numbers; 0 is the ground)");
  link.a = read_link_end(place, (*ends)[0], static_cast<int>(dofs.size()), true);
  link.b = read_link_end(place, (*ends)[1], static_cast<int>(dofs.size()), false);
  if (link.a == link.b) refuse(place, *between, "between", "joins a DOF to itself, expected two different DOFs");
  const auto rotates = [&](int dof) { return dofs[static_cast<size_t>(dof - 1)].rotating; };
  if (link.b > 0 && rotates(link.a) != rotates(link.b))
    refuse(place, *between, "between", "joins a rotating and a translating DOF, expected two of one kind");
}

// A key of the other kind of DOF is the likeliest mistake: the message names the right one.
void refuse_wrong_unit(const Place& place, const toml::table& table, bool rotates) {
  for (const LinkKey& key : kLinkKeys) {
    const std::string wrong = own_key(key.row(), !rotates), right = own_key(key.row(), rotates);
    const toml::node* node = wrong.empty() || wrong == right ? nullptr : table.get(wrong);
    if (node == nullptr) continue;
    const std::string why =
        rotates ? "is of a translating link, but its DOF rotates" : "is of a rotating link, but its DOF translates";
    refuse(place, *node, wrong, why + (right.empty() ? ", expected no such key" : ", expected " + right));
  }
}

Link read_link(const Place& place, const toml::table& table, const RigModel& model) {
  Link link;
  read_ends(place, table, model.dofs, link);
  const bool rotates = link_rotates(model, link);
  refuse_wrong_unit(place, table, rotates);
  std::vector<std::string> known = {"between", "effect"};
  for (const LinkKey& key : kLinkKeys) {
    const std::string name = own_key(key.row(), rotates);
    if (name.empty()) continue;
    known.push_back(name);
    if (const toml::node* node = table.get(name))
      link.*key.field = read_coefficient(place, *node, name, key.may_be_negative());
  }
  require_known_keys(place, table, known);
  const std::string weight = own_key(firmware::row_of(EffectKind::kGravityTorque), true);
  if (const toml::node* gravity = table.get(weight); gravity != nullptr && link.b != kGround)
    refuse(place, *gravity, weight, "stands on a link between DOFs, expected it on a link to the ground (0)");
  link.effects = read_effects(place, table, EffectPlace::kLink, rotates);
  for (const Effect& effect : link.effects)
    if (find_effect_row(effect.kind)->core.term == firmware::TermKind::kGravity && link.b != kGround)
      refuse(place, table, "effect",
             effect.kind + " stands on a link between DOFs, expected it on a link to the ground (0)");
  return link;
}

void read_links(const toml::table& root, RigModel& model) {
  std::set<std::pair<int, int>> seen;
  for (const toml::table* table : table_array({model.file, ""}, root, "link")) {
    const Place place{model.file, "link " + std::to_string(model.links.size() + 1)};
    if (model.links.size() == firmware::kMaxLinks)
      refuse(place, *table, "", "is one too many, expected at most " + std::to_string(firmware::kMaxLinks) + " links");
    model.links.push_back(read_link(place, *table, model));
    const Link& link = model.links.back();
    if (!seen.insert(std::minmax(link.a, link.b)).second)
      refuse(place, *table->get("between"), "between", "repeats an earlier link, expected one link for each pair");
  }
}

void read_dofs(const toml::table& root, RigModel& model) {
  for (const toml::table* table : table_array({model.file, ""}, root, "dof")) {
    const Place place{model.file, "dof " + std::to_string(model.dofs.size() + 1)};
    if (model.dofs.size() == firmware::kMaxDofs)
      refuse(place, *table, "", "is one too many, expected at most " + std::to_string(firmware::kMaxDofs) + " DOFs");
    model.dofs.push_back(read_dof(place, *table));
  }
  if (model.dofs.empty()) refuse({model.file, ""}, root, "dof", "is missing, expected at least one [[dof]]");
}

// The code at zero and the converter's rails.
void read_codes(const Place& place, const toml::table& table, ChannelEntry& entry) {
  const auto code = [&](const char* key, int64_t least, int64_t most, int& value) {
    const toml::node* node = table.get(key);
    if (node != nullptr) value = static_cast<int>(whole_number(place, *node, key, least, most));
    return node != nullptr;
  };
  code("offset_code", -8388608, 8388608, entry.offset_code);
  const bool symmetric = code("full_scale_code", 1, firmware::kLargestCode, entry.highest_code);
  if (symmetric) entry.lowest_code = -entry.highest_code;
  int lowest = 0, highest = 0;
  const bool low = code("lowest_code", -16777216, 16777215, lowest);
  const bool high = code("highest_code", -16777216, 16777215, highest);
  if (!low && !high) return;
  const char* key = low ? "lowest_code" : "highest_code";
  if (symmetric) refuse(place, *table.get(key), key, "stands beside full_scale_code, expected one or the other");
  if (low != high) refuse(place, *table.get(key), key, "stands alone, expected lowest_code and highest_code");
  if (lowest >= highest) refuse(place, *table.get(key), key, "is not below highest_code, expected the lower rail");
  if (highest - entry.offset_code > 8388608 || entry.offset_code - lowest > 8388608)
    refuse(place, *table.get(key), key,
           "lies over 2^23 codes away from offset_code (or highest_code does), expected 24 bits about it");
  entry.lowest_code = lowest;
  entry.highest_code = highest;
}

constexpr double kHighestCoupling_Hz = 100.0;  // of a sensor's own; piezo sensors and inputs have 0.02 to 10

void read_channels(const toml::table& root, const ReadOptions& options, RigModel& model) {
  std::vector<std::string> known = {"name",          "delay_us",     "unit_per_code", "offset_code", "full_scale_code",
                                    "lowest_code",   "highest_code", "column",        "unit",        "sensitivity",
                                    "ac_coupling_Hz"};
  known.insert(known.end(), options.other_channel_keys.begin(), options.other_channel_keys.end());
  for (const toml::table* table : table_array({model.file, ""}, root, "channel")) {
    const Place place{model.file, "channel " + std::to_string(model.channels.size() + 1)};
    require_known_keys(place, *table, known);
    const auto optional = [&](const char* key) { return table->get(key); };
    ChannelEntry entry;
    if (optional("name") == nullptr)
      refuse(place, *table, "name", "is missing, expected a channel such as \"force_1_N\"");
    entry.name = text(place, *optional("name"), "name");
    const std::string fault = channel_name_fault(entry.name, model);
    if (!fault.empty()) refuse(place, *optional("name"), "name", fault);
    for (const ChannelEntry& earlier : model.channels)
      if (earlier.name == entry.name)
        refuse(place, *optional("name"), "name", "repeats an earlier channel, expected each once");
    if (const auto* node = optional("delay_us")) {
      entry.delay_us = finite_number(place, *node, "delay_us");
      if (entry.delay_us < -1e6 || entry.delay_us > 1e6)
        refuse(place, *node, "delay_us", "is over a second, expected -1e6 to 1e6");
    }
    if (const auto* node = optional("ac_coupling_Hz")) {
      entry.ac_coupling_Hz = finite_number(place, *node, "ac_coupling_Hz");
      if (entry.ac_coupling_Hz < 0.0 || entry.ac_coupling_Hz > kHighestCoupling_Hz)
        refuse(place, *node, "ac_coupling_Hz", "is no corner of a sensor's own, expected 0 to 100");
    }
    if (const auto* node = optional("unit_per_code")) {
      entry.unit_per_code = finite_number(place, *node, "unit_per_code");
      if (entry.unit_per_code == 0.0)
        refuse(place, *node, "unit_per_code", "is 0, expected SI units per converter code");
    }
    if (const auto* node = optional("column")) entry.column = text(place, *node, "column");
    if (const auto* node = optional("unit")) entry.unit = text(place, *node, "unit");
    if (const auto* node = optional("sensitivity")) entry.sensitivity = text(place, *node, "sensitivity");
    read_codes(place, *table, entry);
    for (const char* key : {"offset_code", "full_scale_code", "lowest_code", "highest_code"})
      if (optional(key) != nullptr && entry.unit_per_code == 0.0)
        refuse(place, *optional(key), key, "stands without unit_per_code, expected both");
    model.channels.push_back(entry);
  }
}

void check_schema(const Place& top, const toml::table& root) {
  const toml::node* schema = root.get("schema");
  if (schema == nullptr) refuse(top, root, "schema", "is missing, expected schema = \"rig/1\"");
  const std::string found = text(top, *schema, "schema");
  if (found != "rig/1") refuse(top, *schema, "schema", "is \"" + found + "\", expected \"rig/1\"");
}

}  // namespace

RigModel rig_from_toml(const toml::table& root, const std::string& file, const ReadOptions& options) {
  RigModel model;
  model.file = file;
  const Place top{model.file, ""};
  check_schema(top, root);
  std::vector<std::string> known = {"schema", "name", "dof", "link", "channel"};
  known.insert(known.end(), options.other_top_level_keys.begin(), options.other_top_level_keys.end());
  require_known_keys(top, root, known);
  if (const toml::node* name = root.get("name")) model.name = text(top, *name, "name");
  read_dofs(root, model);
  read_links(root, model);
  read_channels(root, options, model);
  compile_rig(model, 1e-3, {});  // refuses what is beyond the core's capacity
  return model;
}

RigModel parse_rig(std::string_view toml_text, const std::string& file, const ReadOptions& options) {
  return rig_from_toml(parse_toml(toml_text, file), file, options);
}

RigModel read_rig_file(const std::string& path, const ReadOptions& options) {
  return rig_from_toml(parse_toml_file(path), path, options);
}

void require_unknowns(const RigModel& model) {
  if (parameter_table(model).empty())
    throw RigFileError(model.file, 0, "", "nothing to estimate, expected at least one coefficient = \"estimate\"");
}

}  // namespace rig_file
