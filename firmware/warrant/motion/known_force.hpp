// The part of every DOF's equation of motion that is known: its measured force less the known terms.
//
// Format: 2^-27 of the sum of all its parts at full scale: finer than the coarsest channel's code.
#pragma once
#include "firmware/configuration/configuration.hpp"

namespace firmware {

class KnownForce {
 public:
  struct Share {  // what a known term adds to a DOF's equation: (column * mantissa) >> shift
    uint8_t dof = 0;
    uint8_t column = 0;
    int8_t shift = 0;
    int32_t mantissa = 0;
  };

  void clear() { shares_ = 0; }
  void add(int dof, int column, const Scaled& coefficient);
  // Once all shares are there: column_unit: SI units of the columns; force_exponent: range of the measured force, where
  // there is one. Returns the SI unit of the sums.
  Scaled scale(int dof, const Scaled* column_unit, bool has_force, int32_t force_exponent);
  // known[n] += shares of the DOF; column: base of the columns of kBlockSamples.
  void add_to(int dof, const int32_t (*column)[kBlockSamples], int64_t* known) const;

  int shares() const { return shares_; }
  const Share& share(int s) const { return share_[s]; }
  Scaled coefficient(int s) const { return coefficient_[s]; }

 private:
  static constexpr int kMaxShares = 2 * kMaxTerms + kMaxDofs;
  Share share_[kMaxShares];
  Scaled coefficient_[kMaxShares];
  int shares_ = 0;
};

constexpr int kKnownFraction = 27;

}  // namespace firmware
