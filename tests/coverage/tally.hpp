// Nothing is hidden: how many coefficients go out VALID, and how many of their 95 % intervals hold the truth.
#pragma once
#include <cstdint>
#include <string>

namespace coverage {

struct Tally {
  int coefficients = 0, valid = 0, held = 0;
  int wrong = 0;                             // VALID, over 5 % and over four quoted standard deviations off
  int measurable = 0, measurable_valid = 0;  // the interval is within 5 % of the truth; and VALID
  int of_status[16] = {};
  int refused = 0;  // draws that the core's plan refuses: a DOF lacks channels
  double valid_percent() const { return coefficients == 0 ? 0.0 : 100.0 * valid / coefficients; }
  double held_percent() const { return valid == 0 ? 0.0 : 100.0 * held / valid; }
  double measurable_valid_percent() const { return measurable == 0 ? 0.0 : 100.0 * measurable_valid / measurable; }
  void add(const Tally& other);
};

// tell: one line per coefficient on stdout.
Tally count(const std::string& condition, const std::string& sensors, uint64_t first_seed, int draws,
            bool tell = false);

}  // namespace coverage
