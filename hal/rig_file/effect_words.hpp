// The words that name an extension term in a rig file, with their core term, shape key and unit.
#pragma once
#include <string>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

enum class EffectPlace { kLink, kDof };

struct EffectWord {
  const char* kind;
  EffectPlace place;
  bool in_core;                // false: only the simulator knows it
  firmware::TermKind term;     // where in_core
  const char* shape_keys[2];   // of a translating link, without unit: {"gap", nullptr}
  const char* shape_units[2];  // "m", "m_s", "Hz", "" ; translation
  const char* rotating_units[2];
  const char* unit;  // of the coefficient, translation
  const char* rotating_unit;
  bool shape_may_be_left_out = false;
};

const std::vector<EffectWord>& effect_words();
const EffectWord* find_effect_word(const std::string& kind);  // nullptr: not a word of the vocabulary

// "gap_m", or "gap_rad" on a rotating link; index 0 or 1; empty where the effect has no such key.
std::string shape_key(const EffectWord& word, int index, bool rotating);
// The first shape parameter of an effect, 0 where it has none.
double first_shape(const Effect& effect, bool rotating);
// How far a drifting coefficient has gone at a time, in s: t, or tau (1 - exp(-t / tau)) where it levels off (tau > 0;
// nought before t = 0).
double drifted_s(double t_s, double time_constant_s);

}  // namespace rig_file
