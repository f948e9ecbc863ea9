// A combination of a table's numbers over many stretches at once has the bits of that over each of them.
#include "firmware/warrant/sums/combination.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

using namespace firmware;

namespace {

constexpr int kValues = 40, kStretches = 61;  // more than once eight, and some that are left

// Sums of every size, some of them zero; a value of zero throughout.
std::unique_ptr<ScoreTable> random_table(std::mt19937_64& random) {
  auto table = std::make_unique<ScoreTable>();
  table->configure(kValues, nullptr, nullptr);
  table->begin_level();
  for (int s = 0; s < kStretches; ++s) {
    for (int v = 0; v < kValues; ++v)
      table->current(v) = v == 7 || random() % 5 == 0 ? 0 : static_cast<int64_t>(random()) >> (random() % 60);
    table->add_block(0);
  }
  return table;
}

}  // namespace

TEST(Combination, OfManyStretchesHasTheBitsOfEach) {
  std::mt19937_64 random(5);
  const auto table = random_table(random);
  ASSERT_EQ(table->stretches(), kStretches);
  for (int trial = 0; trial < 300; ++trial) {
    Combination<kValues> combination;
    combination.clear();
    const int count = static_cast<int>(random() % (kValues + 1));
    for (int i = 0; i < count; ++i)
      combination.add(trial == 0 ? 7 : static_cast<int>(random() % kValues),
                      Scaled::from_int(static_cast<int64_t>(random()) >> (random() % 62),
                                       static_cast<int32_t>(random() % 161) - 80));
    const int from = static_cast<int>(random() % kStretches);
    const int to = from + static_cast<int>(random() % static_cast<uint64_t>(kStretches - from + 1));
    std::vector<Scaled> all(kStretches), added(kStretches, Scaled::ratio(2, 3));
    combination.of_all(*table, from, to, all.data());
    combination.add_all(*table, from, to, added.data());
    for (int s = from; s < to; ++s) {
      const Scaled one = combination.of(*table, s);
      ASSERT_EQ(all[s].mantissa, one.mantissa);
      ASSERT_EQ(all[s].exponent, one.exponent);
      ASSERT_TRUE(added[s] == Scaled::ratio(2, 3) + one);
    }
    for (int s = 0; s < from; ++s) ASSERT_TRUE(all[s].is_zero());
    for (int s = to; s < kStretches; ++s) ASSERT_TRUE(all[s].is_zero());
  }
}
