// What a fitted number is worth.
#pragma once
#include "../diagnosis.hpp"

namespace diagnosis {

// A mass, a spring, a damper or dry friction whose 95 % interval lies wholly below nought: it has taken up what the
// model lacks.
inline bool impossible(const Parameter& p) {
  if (!(p.value + kHalfOf95 * p.std < 0)) return false;
  for (const char* own : {"mass[", "stiffness[", "viscous[", "coulomb["})
    if (p.name.rfind(own, 0) == 0) return true;
  return false;
}

// Status of a fitted parameter: where the model leaves more than noise, its numbers have taken up some of that.
inline const char* status_word(const Parameter& p, bool model_fits) {
  if (p.undetermined) return "ILL_CONDITIONED";
  return model_fits && !impossible(p) && !p.may_be_bent ? "VALID" : "BIAS_SUSPECT";
}

}  // namespace diagnosis
