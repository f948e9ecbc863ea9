// The score tests as the core sees them: sums with the samples, a verdict with the estimates. Where the core is built
// without room for them (FIRMWARE_WARRANT_NUMBERS 0) they take no memory and no time, and estimates go out as they are.
#pragma once
#include "firmware/configuration/zeroed.hpp"
#include "firmware/warrant/verdict/verdict.hpp"

namespace firmware {

#if FIRMWARE_WARRANT_NUMBERS > 0

class ScoreTests {
 public:
  // wanted: the core sums with the instrument. effect_unit as in ScoreSums.
  void configure(const CoreConfiguration& configuration, bool wanted, const Scaled* effect_unit,
                 const ClearSigns& signs) {
    configuration_ = &configuration;
    on_ = wanted && configuration.probe_products_per_sample > 0;
    test_->forget();
    if (on_) sums_->configure(configuration, effect_unit, signs);
  }
  bool on() const { return on_; }
  void clear() {
    if (on_) sums_->clear();
  }
  void begin_level() {
    if (on_) sums_->begin_level();
  }
  void work() { sums_->work(); }  // once a sample, where they are on
  void offer(const Frame& frame, int count) {
    if (on_) sums_->offer(frame, count);
  }
  void break_window() {  // what comes does not follow what came
    if (!on_) return;
    sums_->finish();
    sums_->restart();
  }
  bool merging() const { return on_ && sums_->merging(); }
  void judge(int levels, Estimates& estimates);

  const ScoreSums& sums() const { return *sums_; }
  const ScoreTest& test() const { return *test_; }

 private:
  const CoreConfiguration* configuration_ = nullptr;
  bool on_ = false;
  Zeroed<ScoreSums> sums_;
  Zeroed<ScoreTest> test_;
};

#else

class ScoreTests {
 public:
  void configure(const CoreConfiguration&, bool, const Scaled*, const ClearSigns&) {}
  bool on() const { return false; }
  void clear() {}
  void begin_level() {}
  void work() {}
  void offer(const Frame&, int) {}
  void break_window() {}
  bool merging() const { return false; }
  void judge(int, Estimates&) {}
};

#endif

}  // namespace firmware
