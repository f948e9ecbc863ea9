// Which channels are read at another time or with another gain, after what the warrant has named.
//
// A delay or a gain among the three channels of one DOF needs no model of the rig, and three channels tell which is off: two that
// agree with each other. With two of them nobody knows, and the estimates stay withdrawn. Of a delay that is known to a twentieth of
// itself a twentieth of what it bent is left. What is left is measured again by the samples that follow, and is in the intervals.
#pragma once
#include "firmware/conditioning/conditioning.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

#if FIRMWARE_WARRANT_NUMBERS > 0

class ChannelCorrections {
 public:
  void clear() { count_ = 0; }
  // True: the estimates name a well-measured delay or gain of a channel, which is taken out from now on, beside what is
  // taken out already.
  bool take(const CoreConfiguration& configuration, const Estimates& estimates);
  // After clear(): for the next samples.
  void apply(const CoreConfiguration& configuration, Conditioning& conditioning) const;
  // By what the corrected delays' rest may bend the estimates.
  void widen(const CoreConfiguration& configuration, const BatchTable& table, Estimates& estimates) const;
  // Where nothing else is named: what is taken out, the last one.
  void tell(Estimates& estimates) const;
  bool any() const { return count_ > 0; }

 private:
  struct Correction {
    uint8_t node = 0;
    Quantity quantity = Quantity::kForce;
    Scaled late_s, gain;  // what the channel says is gain times the truth
    Finding last;
  };
  Correction* of(int node, Quantity quantity);

  int count_ = 0;
  Correction correction_[kMostShifted];
};

#else

class ChannelCorrections {
 public:
  void clear() {}
  bool take(const CoreConfiguration&, const Estimates&) { return false; }
  void apply(const CoreConfiguration&, Conditioning&) const {}
  void tell(Estimates&) const {}
  void widen(const CoreConfiguration&, const BatchTable&, Estimates&) const {}
  bool any() const { return false; }
};

#endif

}  // namespace firmware
