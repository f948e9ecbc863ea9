// What records of free decays hold beside them: a hand that leads the rig, a pull that is held, blows that nobody measured.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Samples, the last one left out. clipped: up to its first.
struct DecaySpan {
  size_t from = 0, to = 0;
  bool clipped = false;
};

// The free decays of a record without a force and without a moving base. The energy of the motion is taken as the mean
// square of the rates over one period. Where it rises fourfold within a period the rig was hit. Between such rises,
// nothing but a decay follows what is called its start: the energy never rises again by more than a fifth, falls to a
// quarter, and is seen for at least four periods. Of a decay that does not begin with the record one period more is
// lost (half of one where it lasts fewer than 16). A decay whose start is clipped begins behind it. What follows a wrong start is a free decay still: of beats with a
// hidden mass some are lost. Empty where there is none such, or where three quarters of the loud part of the record are
// none (ambient vibration, a rig that drives itself). Beside one that is long enough neither noise before a trigger nor what has
// too few samples is one. What turns or rolls one way has no period: coasting.hpp.
std::vector<DecaySpan> free_decays(const Record& record);

// Tells of them and of what was dropped beside them, where they are not the whole record.
std::optional<Finding> find_release(const Record& record);

// Takes all else off the records: each decay becomes a record, eight at most where a file holds several. One sentence for each
// record that loses any.
std::vector<std::string> keep_decays(std::vector<Record>& records);

}  // namespace host_sim::data_check
