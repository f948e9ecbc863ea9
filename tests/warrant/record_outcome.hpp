// What the board says of one drawn rig, held against the truth.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "firmware/identification/estimate.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace warrant_test {

struct CoefficientOutcome {
  std::string name;
  double truth = 0, value = 0, std = 0;
  firmware::EstimateStatus status = firmware::EstimateStatus::kStale;
  bool wrong = false;       // over 5 % and over four quoted deviations off, whatever its status
  bool held = false;        // the 95 % interval holds the truth
  bool measurable = false;  // the quoted interval is within 5 % of the truth's size
  bool valid() const { return status == firmware::EstimateStatus::kValid; }
};

struct RecordOutcome {
  uint64_t seed = 0;
  std::string hidden, where;  // the first hidden effect, empty: none
  bool refused = false;       // the core's plan or the generator refuses it
  bool tested = false, suspect = false;
  std::string named, named_where;  // the board's cause in the words of the vocabulary, empty: none
  bool is_cause = false;           // and not only the nearest to something that no candidate explains
  std::vector<CoefficientOutcome> coefficients;
  bool bent() const;             // some coefficient is wrong
  bool valid_and_wrong() const;  // and goes out VALID
};

// The board's answer to the seed's draw; budget: probe_products_per_sample.
RecordOutcome outcome_of(uint64_t seed, const hidden_rig::Settings& settings, uint16_t budget = 65535);
std::string describe(const RecordOutcome& outcome);  // some lines of text

}  // namespace warrant_test
