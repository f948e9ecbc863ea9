// Coefficients and [[link.effect]] / [[dof.effect]] tables of a rig file.
#pragma once
#include <string_view>
#include <vector>

#include "hal/rig_file/toml/effect_words.hpp"
#include "hal/rig_file/toml/toml_checks.hpp"

namespace rig_file {

// A number or "estimate".
Coefficient read_coefficient(const Place& place, const toml::node& node, std::string_view key, bool may_be_negative);
std::vector<Effect> read_effects(const Place& parent, const toml::table& table, EffectPlace where, bool rotating);

}  // namespace rig_file
