// What the diagnosis says of rigs drawn under a condition, and the tables that count it.
#pragma once
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace hidden_rig {

enum class Outcome {
  kRight,   // nothing hidden: "none"; hidden: named by effect and place, nothing else
  kInSet,   // hidden: one of at most four that are named as alternatives
  kMissed,  // hidden, and "none", "unknown" or a larger set said
  kWrong,   // something named that is not there, or "explained" without what is hidden
  kRefused  // the diagnosis threw
};
const char* outcome_word(Outcome outcome);

struct Said {
  std::string condition, sensors;
  uint64_t seed = 0;
  bool hides = false;
  Outcome outcome = Outcome::kMissed;
  double seconds = 0;              // of one core
  int intervals = 0, holding = 0;  // of coefficients that the rig file leaves open, where the answer was right
  std::string text;                // truth and answer in one line
};

Outcome judge(const Draw& draw, diagnosis::Diagnosis answer);
// One draw, diagnosed. What can hide: every word of effects() but faults of the data themselves (dead, clipped, ...).
// effect: the word that is hidden; empty: any.
Said ask(const std::string& condition, const std::string& sensors, bool hides, uint64_t seed,
         const std::string& effect = "");

// By condition and by sensors; conditions.py reads it.
void write_table(std::ostream& out, const std::vector<Said>& all);

}  // namespace hidden_rig
