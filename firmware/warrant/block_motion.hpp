// One block of samples taken out of the stream for the score tests, and what the equations of motion make of it: the part
// of every DOF's equation that is known, and the columns of the unknown terms.
//
// Formats (signals are codes of 24 bits, an acceleration made from velocities 27 bits):
//   difference of two nodes      Q26 of its range 2^range_exponent, |.| <= 2^26
//   from the neighbours t+-1..4  sums of 256 codes, times 8/172: code in Q3, 31 bits; then as above
//   known part of an equation    2^-27 of the sum of all its terms at full scale: finer than the coarsest channel's code
//   sign of a rate               Q20, a straight line over +-5/4 standard deviations of the rate's noise
#pragma once
#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

// Samples before and after a block that the instrument reaches.
constexpr int kProbeLead = 4;
constexpr int kProbeSamples = kProbeLead + kBlockSamples + kProbeLead;

// A difference of the same quantity at two nodes, or the quantity at one node.
struct Difference {
  uint16_t row_a = 0, row_b = 0;   // of BlockMotion::signal
  int32_t gain_a = 0, gain_b = 0;  // Q25 of the range per code; 0: not there
  int32_t range_exponent = 0;
};

// The regressors of the equations: numbers of BlockMotion::column.
constexpr int kKnownColumn = 0;                                   // + DOF
constexpr int kElongationColumn = kKnownColumn + kMaxDofs;        // + link
constexpr int kRateColumn = kElongationColumn + kMaxLinks;        // + link
constexpr int kSoftSignColumn = kRateColumn + kMaxLinks;          // + link
constexpr int kAccelerationColumn = kSoftSignColumn + kMaxLinks;  // + DOF
constexpr int kForceLawColumn = kAccelerationColumn + kMaxDofs;   // + effect
constexpr int kMotionColumns = kForceLawColumn + kMaxEffectColumns;

class BlockMotion {
 public:
  void configure(const CoreConfiguration& configuration, const Scaled* effect_unit);
  Difference difference(Quantity quantity, int node_a, int node_b) const;

  void restart() { filled_ = 0; }  // what comes next does not follow what came
  // Takes positions [kLeadIn + from, kLeadIn + count) of the frame, as far as there is room; returns how many.
  int append(const Frame& frame, int from, int count);
  bool full() const { return filled_ == kProbeSamples; }
  void keep_tail();  // the block is done: its last samples are the lead of the next
  // Variance of a velocity's noise, for the width of soft signs: of the rate of a link, in Q26 of its range.
  void set_rate_noise(int link, int64_t deviation_q26) { rate_noise_[link] = deviation_q26; }
  void fill_columns();  // of a full block

  const int32_t* signal(int row) const { return &signal_[row][kProbeLead]; }                 // [-4, kBlockSamples + 4)
  static int32_t own(const Difference& d, const int32_t* a, const int32_t* b, int at);       // Q26
  static int32_t smoothed(const Difference& d, const int32_t* a, const int32_t* b, int at);  // Q26, own sample left out
  static int32_t slope(const Difference& d, const int32_t* a, int at);                       // Q26 per sample, likewise

  const int32_t* column(int number) const { return column_[number]; }
  Scaled column_unit(int number) const { return unit_[number]; }
  int column_of(const Term& term, int number) const;  // term: the number-th of the configuration

 private:
  struct Share {  // what a known term adds to a DOF's equation: (column * mantissa) >> shift
    uint8_t dof = 0;
    uint8_t column = 0;
    int8_t shift = 0;
    int32_t mantissa = 0;
  };
  static constexpr int kMaxShares = 2 * kMaxTerms + kMaxDofs;
  void add_share(int dof, int column, Scaled coefficient);
  void scale_known(int dof);
  void fill_acceleration(int dof);

  const CoreConfiguration* configuration_ = nullptr;
  Difference elongation_[kMaxLinks], rate_[kMaxLinks], acceleration_[kMaxDofs], force_[kMaxDofs];
  bool has_elongation_[kMaxLinks], has_force_[kMaxDofs], derives_acceleration_[kMaxDofs];
  Scaled signal_unit_[kMaxNodes * kQuantities];
  uint8_t effect_of_term_[kMaxTerms];
  int effects_ = 0;
  int64_t rate_noise_[kMaxLinks] = {};
  Share share_[kMaxShares];
  Scaled share_value_[kMaxShares];
  int shares_ = 0;
  int filled_ = 0;
  alignas(16) int32_t signal_[kMaxNodes * kQuantities][kProbeSamples];
  alignas(16) int32_t force_law_[kMaxEffectColumns][kProbeSamples];
  alignas(16) int32_t column_[kMotionColumns][kBlockSamples];
  Scaled unit_[kMotionColumns];
};

}  // namespace firmware
