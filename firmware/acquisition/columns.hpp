// One block of every signal that the energy equations multiply, side by side as integer columns.
//
// The binary point of an entry is in the type of its column: Code for signals (|c| <= 2^23), instruments (six times the
// velocity or displacement: 10 * 2^23) and signs, PassedSign for signs behind a filter, LawForce for effect terms (one
// is 2^26). What multiplies any two columns alike, the product sums, takes them raw, and the plan of the equations knows
// their units. A product is below 2^26.4 * 2^26; a batch sums at most 1024 of them: below 2^62.4, exact in int64.
//
// A frame holds 3 samples before the block and 4 after it: the instrument reaches 2 samples to either side and the end
// corrections of the integrals look one sample further, also at the sample that follows the block.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"
#include "firmware/fixed_point/fixed.hpp"

namespace firmware {

constexpr int kLeadIn = 3;
constexpr int kLeadOut = 4;
constexpr int kFrameSamples = kLeadIn + kBlockSamples + kLeadOut;
constexpr int kFrameStride = (kFrameSamples + 3) / 4 * 4;  // rounded up for alignment
// The first and last samples of a level only give context: n samples make a window of n - kLevelMarginSamples intervals.
constexpr int kLevelMarginSamples = kLeadIn + kLeadOut;

// Column numbers: signals first, node by node.
constexpr int kSignalColumns = kMaxNodes * kQuantities;
constexpr int kInstrumentColumn = kSignalColumns;                            // + DOF
constexpr int kDisplacementInstrumentColumn = kInstrumentColumn + kMaxDofs;  // + DOF: likewise of the displacement
constexpr int kDisplacementInstruments = kWeights > 2 ? kMaxDofs : 0;
constexpr int kSignColumn = kDisplacementInstrumentColumn + kDisplacementInstruments;  // + link: sgn(w)
constexpr int kSmoothSignColumn = kSignColumn + kMaxLinks;  // + link: sgn of the smoothed rate
constexpr int kClearSignColumn =
    kSmoothSignColumn + kMaxLinks;  // + link: sgn of the instrument's rate where clear, else 0
// + DOF: the two instruments where every friction at the DOF has a clear sign, else 0
constexpr int kClearInstrumentColumn = kClearSignColumn + kMaxLinks;
constexpr int kClearDisplacementColumn = kClearInstrumentColumn + kMaxDofs;
// + node: the velocity whose sign friction has, where the others pass a high-pass (conditioning.hpp)
constexpr int kSignVelocityColumn = kClearDisplacementColumn + kDisplacementInstruments;
constexpr int kEffectColumn = kSignVelocityColumn + (kDerivesSignals ? kMaxNodes : 0);  // + effect number
constexpr int kMaxColumns = kEffectColumn + kMaxEffectColumns;

constexpr int signal_column(int node, Quantity quantity) { return node * kQuantities + static_cast<int>(quantity); }

using Code = Fixed<int32_t, 0>;
using LawForce = Fixed<int32_t, 26>;

// One column of a frame as what it holds.
template <typename Number>
class Column {
 public:
  explicit Column(int32_t* raw) : raw_(raw) {}
  Number operator[](int i) const { return Number::from_raw(raw_[i]); }
  void put(int i, Number number) { raw_[i] = number.raw; }

 private:
  int32_t* raw_;
};
template <typename Number>
class ConstColumn {
 public:
  explicit ConstColumn(const int32_t* raw) : raw_(raw) {}
  Number operator[](int i) const { return Number::from_raw(raw_[i]); }

 private:
  const int32_t* raw_;
};

struct Frame {
  alignas(16) int32_t raw[kMaxColumns][kFrameStride];

  // column: a signal, an instrument or a sign.
  Column<Code> codes(int column) { return Column<Code>(raw[column]); }
  ConstColumn<Code> codes(int column) const { return ConstColumn<Code>(raw[column]); }
  Column<PassedSign> passed_sign(int link) { return Column<PassedSign>(raw[kClearSignColumn + link]); }
  Column<LawForce> effect(int number) { return Column<LawForce>(raw[kEffectColumn + number]); }
};

}  // namespace firmware
