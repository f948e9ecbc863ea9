// What the board says of the rig's model beside its numbers: cause, place, size and the nearest rival, in words.
#pragma once
#include <string>
#include <vector>

#include "firmware/identification/estimate.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

struct FindingResult {
  std::string effect;  // the vocabulary's word; empty: nothing found
  std::string where;   // "link 1-2", "dof 3", "channel displacement_2_m"
  double size = 0.0, std = 0.0;
  std::string unit;
};
struct WarrantResult {
  bool tested = false;
  FindingResult named, rival;
  // Whether named is the cause, or only the nearest to something that the rig file lacks; and of what stands out along its force, beyond
  // noise, what it takes away (0: nothing is known of that).
  firmware::Naming naming = firmware::Naming::kExplains;
  double explains_percent = 0.0;
  double rival_percent = 0.0;  // gain in log-likelihood, of the named cause's
  // Delays and gains of channels that have been taken out of these estimates. Where that explains everything, named is the
  // first of them.
  std::vector<FindingResult> corrected;
  bool explained = false;  // by what has been corrected
};

// Whether something is found that no correction explains.
bool suspects(const WarrantResult& warrant);
// Nothing where the named cause is the cause; else why it is not, in words that follow it.
std::string why_not_the_cause(const WarrantResult& warrant);
WarrantResult warrant_of(const rig_file::RigModel& model, const firmware::Warrant& warrant);
// One line, ends without a line break.
std::string warrant_text(const WarrantResult& warrant);
// How to go on where something is suspected; empty elsewhere.
std::string after_suspicion(const WarrantResult& warrant);

}  // namespace host_sim
