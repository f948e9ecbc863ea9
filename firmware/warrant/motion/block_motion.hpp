// One block of samples taken out of the stream for the score tests, and what the equations of motion make of it: the part
// of every DOF's equation that is known, and the columns of the unknown terms.
//
// Formats (signals are codes of 24 bits, an acceleration made from velocities 27 bits):
//   difference of two nodes      Q26 of its range (links/node_difference.hpp)
//   known part of an equation    known_force.hpp
//   sign of a rate               Q20. Where the energy rows count friction at samples of clear sign alone, their very column;
//                                elsewhere a straight line over +-5/4 standard deviations of the rate's noise
#pragma once
#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/wide.hpp"
#include "firmware/warrant/motion/known_force.hpp"
#include "firmware/warrant/motion/neighbours.hpp"

namespace firmware {

// Samples before and after a block that the instrument reaches.
constexpr int kProbeLead = kNeighbours;
constexpr int kProbeSamples = kProbeLead + kBlockSamples + kProbeLead;

// The regressors of the equations: numbers of BlockMotion::column.
constexpr int kKnownColumn = 0;                                   // + DOF
constexpr int kElongationColumn = kKnownColumn + kMaxDofs;        // + link
constexpr int kRateColumn = kElongationColumn + kMaxLinks;        // + link
constexpr int kSoftSignColumn = kRateColumn + kMaxLinks;          // + link
constexpr int kAccelerationColumn = kSoftSignColumn + kMaxLinks;  // + DOF
constexpr int kForceLawColumn = kAccelerationColumn + kMaxDofs;   // + effect
// What a DOF's velocity has beyond the slope of its displacement, its acceleration beyond that of its velocity.
enum class Slope : uint8_t { kOfDisplacement, kOfVelocity };
constexpr int kSlopes = 2;
constexpr int slope_rest_column(Slope slope, int dof) {
  return kForceLawColumn + kMaxEffectColumns + static_cast<int>(slope) * kMaxDofs + dof;
}
constexpr int kMotionColumns = slope_rest_column(Slope::kOfVelocity, kMaxDofs);

// The DOF's quantity and its slope are both as measured.
bool measures_slope(const CoreConfiguration& configuration, Slope slope, int dof);

// Where the energy rows take friction's sign, and which samples their equations leave out.
struct ClearSigns {
  bool link[kMaxLinks] = {};  // has a column kClearSignColumn
  bool dof[kMaxDofs] = {};    // its equation leaves samples out: kClearInstrumentColumn is zero there
  bool filtered = false;      // the column holds 2^20 times the sign
};

// w 2^bits / width within +-width, towards zero; +-2^bits beyond; width at most 2^43, 0: the sign alone.
inline int32_t soft_sign(int64_t w, int64_t width, int bits) {
  if (size_of(w) >= width) return ((w > 0) - (w < 0)) * (1 << bits);
  const auto size = static_cast<uint64_t>(size_of(w)) << bits;
  const auto share = static_cast<int32_t>(short_quotient(size, static_cast<uint64_t>(width), bits));
  return w < 0 ? -share : share;
}

class BlockMotion {
 public:
  // effect_unit: SI unit of every effect term's column, in the order of the terms.
  void configure(const CoreConfiguration& configuration, const Scaled* effect_unit, const ClearSigns& signs);
  NodeDifference difference(Quantity quantity, int node_a, int node_b) const;

  void restart() { filled_ = 0; }  // what comes next does not follow what came
  // Takes positions [kLeadIn + from, kLeadIn + count) of the frame, as far as there is room; returns how many.
  int append(const Frame& frame, int from, int count);
  bool full() const { return filled_ == kProbeSamples; }
  void keep_tail();  // the block is done: its last samples are the lead of the next
  // Variance of a velocity's noise, for the width of soft signs: of the rate of a link, in Q26 of its range.
  void set_rate_noise(int link, int32_t deviation_q26) { rate_noise_[link] = deviation_q26; }
  // Of a full block, one after the other.
  void fill_neighbours();
  void fill_columns();

  const int32_t* signal(int row) const { return &signal_[row][kProbeLead]; }  // [-4, kBlockSamples + 4)
  // The same from the four samples on either side of each (neighbours.hpp): codes in Q3.
  const int32_t* between_neighbours(int row) const { return near_[row]; }
  int32_t smoothed_at(const NodeDifference& d, int n) const;
  // Does the equation of the DOF leave samples out? Which it counts, and beside no reversal of friction at the DOF.
  bool leaves_out(int dof) const { return signs_.dof[dof]; }
  bool counted(int dof, int sample) const {
    return counted_[dof][kProbeLead + sample] != 0;
  }  // [-4, kBlockSamples + 4)
  bool counts(int dof, int sample) const { return settled_[dof][sample]; }
  bool has_clear_sign(int link) const { return signs_.link[link]; }
  // From the slope of velocities: what jumps in the acceleration is then smeared over kNeighbours samples on either side.
  bool derives_acceleration(int dof) const { return derives_acceleration_[dof]; }

  const int32_t* column(int number) const { return column_[number]; }
  const Scaled& column_unit(int number) const { return unit_[number]; }
  int column_of(const Term& term, int number) const;  // term: the number-th of the configuration
  const KnownForce& known() const { return known_; }

 private:
  void configure_effects(const Scaled* effect_unit);
  void share_known_terms();
  void fill_acceleration(int dof);
  void fill_settled();
  bool turns(int link, int sample) const;
  void fill_link(int link);
  void fill_soft_sign(int link);
  void fill_known(int dof);
  void configure_slope(Slope slope, int dof);
  void fill_slope_rest(Slope slope, int dof);

  const CoreConfiguration* configuration_ = nullptr;
  int effects_ = 0;
  int filled_ = 0;
  ClearSigns signs_;
  Scaled signal_unit_[kMaxNodes * kQuantities];
  NodeDifference elongation_[kMaxLinks], rate_[kMaxLinks], acceleration_[kMaxDofs], force_[kMaxDofs];
  bool derives_acceleration_[kMaxDofs] = {};  // from velocities, here
  int32_t rate_noise_[kMaxLinks] = {};
  uint8_t effect_of_term_[kMaxTerms] = {};
  KnownForce known_;
  struct SlopeUnit {
    NodeDifference steeper;  // the quantity that is the other's slope
    int32_t mantissa = 0;    // 840 slopes of the other's codes to its Q16; 0: not both are measured
    int8_t shift = 0;
  };
  SlopeUnit slope_[kSlopes][kMaxDofs];
  alignas(16) int32_t signal_[kMaxNodes * kQuantities][kProbeSamples];
  alignas(16) int32_t near_[kMaxNodes * kQuantities][kBlockSamples];
  alignas(16) int32_t force_law_[kMaxEffectColumns][kProbeSamples];
  alignas(16) int32_t clear_sign_[kMaxLinks][kProbeSamples];
  alignas(16) int32_t counted_[kMaxDofs][kProbeSamples];  // zero: left out
  bool settled_[kMaxDofs][kBlockSamples];
  alignas(16) int32_t column_[kMotionColumns][kBlockSamples];
  Scaled unit_[kMotionColumns];
};

}  // namespace firmware
