// The whole numeric path behind one door: raw samples in, estimates out. No clock, no bus, no operating system.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/conditioning/conditioning.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/configuration/zeroed.hpp"
#include "firmware/energy/batch_collector.hpp"
#include "firmware/energy/energy_sums.hpp"
#include "firmware/identification/identification.hpp"
#include "firmware/warrant/score_tests.hpp"
#include "firmware/warrant/verdict/channel_correction.hpp"

namespace firmware {

struct CoreHealth {
  uint32_t samples = 0;
  uint32_t missed_samples = 0;     // gaps in RawSample::sequence
  uint32_t saturated_samples = 0;  // samples with a channel at its full scale
};

enum class CoreDetail : uint8_t {
  kPlain = 1,  // the paper's sums only
  kFull = 3,   // with the instrument and, where a mass, a spring or the like is unknown, the displacement weight
};

class EstimatorCore {
 public:
  // The configuration is used in place: it must outlive the core and not change.
  explicit EstimatorCore(const CoreConfiguration& configuration, CoreDetail detail = CoreDetail::kFull);
  void reset();        // forgets all levels
  void begin_level();  // a new excitation level or record: filters and sums restart
  // A gap in the samples' sequence numbers is counted and splits the window: no integral runs across it. Constant cost
  // per sample on average; the work is done every kBlockSamples samples.
  void push(const RawSample& sample);
  bool saturated() const {
    return conditioning_->saturated();
  }                  // of the last sample: a channel at a rail, a signal cut off
  void end_level();  // closes the window
  // A table's batches, or the stretches of the score tests, are being merged, a few with each sample: ending the level now
  // would merge the rest at once, which takes about as long as a hundred batches.
  bool merges_with(const RawSample& next) const {
    return next.sequence != next_sequence_ && sequence_known_ && merges_at_end();
  }
  bool merges_at_end() const { return collector_.merging() || tests_.merging(); }
  // The last sample has completed a block: its columns and score tests are done, its sums come with the next one.
  bool owes_sums() const { return filled_columns_ != 0; }
  // From everything since reset(), or since a channel was corrected; may be called at any time. Where the configuration allows it,
  // a delay or gain of a channel that the estimates name, well measured, is taken out of what comes then: all levels are forgotten,
  // and an open one begins anew.
  // Where all samples of an open level since the last solve went into filters that settle, VALID becomes STALE: nothing is new.
  const Estimates& solve();
  const Estimates& estimates() const { return estimates_; }  // of the last solve
  const CoreHealth& health() const { return health_; }
  const BatchTable& table() const { return table_; }
  // Of the last solve: how the estimates move together.
  const NormalEquations& normal_equations() const { return stages_->memory.fit.equations(); }
  const ScoreTests& score_tests() const { return tests_; }
#if FIRMWARE_WARRANT_NUMBERS > 0
  const ScoreSums& score_sums() const { return tests_.sums(); }
  const ScoreTest& score_test() const { return tests_.test(); }
#endif
  // False: the configuration needs more products of columns or conservative unknowns than this core has room for.
  bool fits() const { return stages_->sums.complete() && fits_; }
  int margin_samples() const { return conditioning_->margin_samples(); }  // of a level, that are in no window

 private:
  void choose_block();
  void process(int count);
  void move_on();
  void fill_columns(int count);
  void break_window(uint32_t time = 0);  // time: samples from the level's start to the one that comes next
  void note_gap(uint32_t sequence);
  void note_saturation();
  void forget_levels();
  void correct_channels();
  void tell_stale();
  void aim(
      uint32_t units = 0);  // where the batch that starts now ends; units: of the batch before it, still to be added
  void close_some();
  void go_on_closing();
  void finish_closing();

  const CoreConfiguration& configuration_;
  // What every sample looks at stands together in front.
  CoreHealth health_;
  uint32_t next_sequence_ = 0;
  bool sequence_known_ = false;
  bool fits_ = true;
  bool forgets_ = false;       // what was measured, when the next level begins: a channel is corrected
  bool tests_work_ = false;    // the score tests are on
  bool closing_ = false;       // into the batch at hand, a few pieces with each sample
  bool starved_ = false;       // since the last solve: a sample of an open level went into filters that settle
  uint32_t unfed_ = 0;         // samples since then that were none of a level's, or went into such filters
  uint32_t told_samples_ = 0;  // health_.samples at that solve
  int pieces_per_sample_ = 1;
  int filled_ = 0;            // samples in the frame
  int full_ = 0;              // at this many the block is worked on
  int filled_columns_ = 0;    // samples of a block whose columns are filled and which is to be summed
  uint32_t level_began_ = 0;  // health_.samples then, less what has been missed since
  uint32_t closing_units_ = 0;
  uint32_t level_samples_ = 0;                      // sample intervals summed since the level (or a gap in it) began
  uint32_t units_ = 0, units_aimed_ = 0, aim_ = 0;  // units summed, to be summed, and the latter in samples
  BatchCollector collector_{table_};
  // What is not zero in those that are cleared at once the configuration sets.
  Zeroed<Conditioning> conditioning_;
  Frame frame_ = {};
  struct Stages {
    EnergySums sums;
    IdentificationMemory memory;
    Batch batch;
  };
  Zeroed<Stages> stages_;
  BatchTable table_;
  ScoreTests tests_;
  Zeroed<ChannelCorrections> corrections_;
  Estimates estimates_;
};

}  // namespace firmware
