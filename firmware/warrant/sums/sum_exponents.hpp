// What a unit of an exact sum is in the table: 2^exponent. The exact sums count in the scale that their place has now, the table
// in one that holds for the whole record, so that a scale may grow and nothing that was summed is lost.
//
// A force goes with at most the third power of its quantities, its sum with its own force with the sixth: 6 * -14 to 6 * 13.
#pragma once
#include "firmware/warrant/probes/probe_force.hpp"

namespace firmware {

// Of one probe: how its sums go with the scale of its place.
class ProbeExponents {
 public:
  ProbeExponents(const ProbePlan& plan, const Probe& probe, const PlaceScale& scale)
      : own_value_(plan.own_value(probe) - probe.first_value) {
    const Powers power = powers_of(probe.form);
    for (int q = 0; q < 2; ++q) {
      quantity_[q] = scale.shift[q] - kTableScaleShift;
      force_ += power.of[q] * quantity_[q];
    }
  }
  // value: of the probe. With a column, with its own force, of its slopes.
  int of(int value) const {
    if (value < own_value_) return force_;
    if (value == own_value_) return 2 * force_;
    return force_ - (value == own_value_ + 1 ? quantity_[0] : quantity_[1]);
  }

 private:
  int own_value_, force_ = 0, quantity_[2];
};

}  // namespace firmware
