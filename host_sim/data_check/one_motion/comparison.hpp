// Two channels of one DOF beside each other, over the whole record at the span (sides.hpp) where they agree best.
#pragma once
#include <optional>

#include "host_sim/data_check/one_motion/integrals.hpp"

namespace host_sim::data_check {

struct Comparison {
  Quantity lower = Quantity::kDisplacement, upper = Quantity::kVelocity;  // upper: once or twice differentiated
  double correlation = 0.0;               // of both sides, at the span where its magnitude is largest
  double gain = 1.0;                      // upper over the derivative of lower, with its sign
  double late_s = 0.0, late_std_s = 0.0;  // upper behind lower
  bool turned = false;                    // the correlation is negative for every delay of up to 3 samples
  double independent = 0.0;               // about how many independent spans stand behind it
};

// Nothing where the record is too short to say (less than 30 independent spans).
std::optional<Comparison> compare(const Channel& lower, const Channel& upper, double sample_period_s,
                                  Integrals& integrals);

// The magnitude of that correlation alone; 0 where the record is too short to say.
double agreement(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals);

}  // namespace host_sim::data_check
