// A linear combination of the sums of a stretch: what the scores of a probe are, once the estimates are known.
#pragma once
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/score_table.hpp"

namespace firmware {

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
    report_work(100 + 50 * count_);
    return sum_of_products<kMost>(
        count_, [&](int i) { return coefficient_[i]; }, [&](int i) { return table.number(stretch, value_[i]); });
  }

 private:
  int count_ = 0;
  uint16_t value_[kMost];
  ShortScaled coefficient_[kMost];
};

}  // namespace firmware
