// The force laws of the probes over one block: from the neighbours of each sample (the instrument, whose noise the
// sample's own residual does not contain), and from the sample itself (what a hidden force of that law would be).
//
// Formats: elongation, rate, acceleration and force in Q18 of a power of two near their own rms, at most 32 of it: 2^23.
// Products of them are shifted back to at most 2^24: u^2 in Q14, u^3 in Q9. A force is below 2^24.
#pragma once
#include "firmware/warrant/motion/block_motion.hpp"
#include "firmware/warrant/probes/probe.hpp"

namespace firmware {

constexpr int kNormalBits = 18;
constexpr int kLeastScaleShift = -kNormalBits;  // one of Q26 is one unit
// The scale that sums of different scales are counted in; in the middle of those that there are, -18 to 9.
constexpr int kTableScaleShift = -4;

// What a place's first and second quantity are: elongation and rate; on a DOF acceleration and force.
struct PlaceScale {
  bool present[2] = {};
  NodeDifference difference[2];
  int8_t shift[2] = {kLeastScaleShift, kLeastScaleShift};  // Q26 of the range to Q18 of the rms
  int32_t noise_q26 = 0;                                   // deviation of the rate's noise
  bool near_friction = false;  // samples close to a reversal are left out, where the equations do not say which
  bool smeared = false;        // and those whose acceleration is a slope that reaches across the reversal
};

struct PlaceMotion {
  int32_t instrument[2][kBlockSamples];
  int32_t own[2][kBlockSamples];
  int32_t slope[2][kBlockSamples], own_slope[2][kBlockSamples];  // DOFs only; of a link slope[0] holds find_edges()
  int32_t own_sign[kBlockSamples];                               // of the rate, Q20; not of DOFs
  int32_t used[kBlockSamples];                                   // all bits, or none
};

// A sample with which a run of samples begins or ends that a link's equations leave out beside a reversal of its friction. Noise that
// its neighbours share chooses which one that is: a law phi of the rate w counts where |w| passes a threshold T, and for Gaussian noise
// the mean of phi times noise has the slope of that choice too, phi(w) sgn(w) delta(|w| - T). One of these samples stands for
// 1 / |change of w per sample| of the density there. After fill_motion(), where sum_slopes() is asked for.
void find_edges(const BlockMotion& block, const Place& place, PlaceMotion& motion);
void fill_motion(const BlockMotion& block, const Place& place, const PlaceScale& scale, PlaceMotion& motion);
// phi from the neighbours, own from the sample itself; zero where the sample is not used.
void fill_force(Form form, const PlaceScale& scale, const PlaceMotion& motion, int32_t* phi, int32_t* own);
// Powers of the first and second quantity that the force's unit goes with.
struct Powers {
  int8_t of[2];
};
constexpr Powers powers_by_name(Form form) {
  switch (form) {
    case Form::kElongationSquare:
      return {{2, 0}};
    case Form::kElongationCube:
      return {{3, 0}};
    case Form::kRate:
    case Form::kRateMagnitude:
    case Form::kForce:
    case Form::kForceRate:
      return {{0, 1}};
    case Form::kRateSquare:
      return {{0, 2}};
    case Form::kRateCube:
      return {{0, 3}};
    case Form::kElongationSquareRate:
      return {{2, 1}};
    case Form::kForceWithinGap:
    case Form::kConstant:
    case Form::kSign:
    case Form::kSignNarrow:
    case Form::kSignWide:
      return {{0, 0}};
    default:
      return {{1, 0}};
  }
}
// Made when compiling, for a table takes less room than the choice.
struct PowersOfForms {
  Powers of[kForms];
  constexpr PowersOfForms() : of() {
    for (int form = 0; form < kForms; ++form) of[form] = powers_by_name(static_cast<Form>(form));
  }
};
inline constexpr PowersOfForms kPowersOfForms;
constexpr Powers powers_of(Form form) { return kPowersOfForms.of[static_cast<int>(form)]; }
// SI unit of fill_force's numbers in the table's scale is 2^this (of N for pure numbers).
int32_t force_exponent(Form form, const PlaceScale& scale);
// Sums over the block of phi(q + h) - phi(q - h) for the first and the second quantity, h = 2^kSlopeStepLog2 of their Q18, and of a
// link's edges.
constexpr int kSlopeStepLog2 = 15;
void sum_slopes(Form form, const PlaceScale& scale, const PlaceMotion& motion, bool edges, int64_t* first,
                int64_t* second);
// SI units of the quantity in one of its Q18, in the table's scale: 2^this.
int32_t quantity_exponent(const PlaceScale& scale, int quantity);

}  // namespace firmware
