// Did the diagnosis find what the draw hides?
#pragma once
#include <string>

#include "draw.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"

namespace hidden {

enum class Outcome {
  kExact,  // every hidden effect by name and place, nothing else; "none" where nothing is hidden; "unknown" outside
  kSet,    // the same, but an effect is one of a set of equivalents
  kWrong
};

diagnosis::Diagnosis answer_to(const Draw& draw);  // without a word of what is hidden
Outcome judge(const Draw& draw, const diagnosis::Diagnosis& diagnosis);
std::string told(const Draw& draw, const diagnosis::Diagnosis& diagnosis);  // one line: truth and answer

}  // namespace hidden
