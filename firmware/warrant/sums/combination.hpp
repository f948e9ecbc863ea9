// A linear combination of the sums of a stretch: what the scores of a probe are, once the estimates are known.
#pragma once
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/sums/score_table.hpp"

namespace firmware {

#ifdef FIRMWARE_IN_PLACE
// Of stretches from `from` on, to sums[from] and on: the sum of coefficient i times value i, i below count. Some of them side by side;
// returns the first that is left, before `to`. The numbers are those of sum_of_products.
int combine(const ShortScaled* coefficient, const uint16_t* value, int count, const ScoreTable& table, int from, int to,
            Scaled* sums);
#else
// Of one stretch: the sum of coefficient i times value i, i below count. Where there is no table, times number i: one routine for both.
Scaled combined(const ShortScaled* coefficient, int count, const ShortScaled* number, const uint16_t* value,
                const ScoreTable* table, int stretch);
#endif

// Sum of products of two arrays of count <= kMost numbers.
template <int kMost>
Scaled sum_of_arrays(int count, const ShortScaled* a, const ShortScaled* b) {
#ifdef FIRMWARE_IN_PLACE
  return sum_of_kept<kMost>(
      count, [&](int i) { return a[i]; }, [&](int i) { return b[i]; });
#else
  return combined(a, count, b, nullptr, nullptr, 0);
#endif
}

template <int kMost>
class Combination {
 public:
  void clear() { count_ = 0; }
  void add(int value, const Scaled& coefficient) {
    if (coefficient.is_zero()) return;
    value_[count_] = static_cast<uint16_t>(value);
    coefficient_[count_++] = short_scaled(coefficient);
  }
  Scaled term(const ScoreTable& table, int stretch, int i) const {
    return long_scaled(coefficient_[i]) * table.value(stretch, value_[i]);
  }
  Scaled of(const ScoreTable& table, int stretch) const {
#ifdef FIRMWARE_IN_PLACE
    report_work(100 + 50 * count_);
    return sum_of_products<kMost>(
        count_, [&](int i) { return coefficient_[i]; }, [&](int i) { return table.number(stretch, value_[i]); });
#else
    return combined(coefficient_, count_, nullptr, value_, &table, stretch);
#endif
  }
  // Of the stretches [from, to), to sums[from] and on.
  void of_all(const ScoreTable& table, int from, int to, Scaled* sums) const {
#ifdef FIRMWARE_IN_PLACE
    from = combine(coefficient_, value_, count_, table, from, to, sums);
#endif
    for (int s = from; s < to; ++s) sums[s] = of(table, s);
  }
  void add_all(const ScoreTable& table, int from, int to, Scaled* sums) const {
#ifdef FIRMWARE_IN_PLACE
    Scaled added[kMostStretches];
    of_all(table, from, to, added);
    for (int s = from; s < to; ++s) sums[s] += added[s];
#else
    for (int s = from; s < to; ++s) sums[s] += of(table, s);
#endif
  }

 private:
  int count_ = 0;
  uint16_t value_[kMost];
  ShortScaled coefficient_[kMost];
};

}  // namespace firmware
