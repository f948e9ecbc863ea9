// The estimator core as the controller uses it. Two things take longer than a sample period: a
// solve (3 DOF, full table: some 12 million instructions of a 32-bit processor) and the merging of a full table's
// batches. They run on a worker while samples, drive and stop line go on.
//
// What the controller asks for is done at once while nothing runs; else it waits in a ring and is done afterwards, in
// the order of asking. So the estimates do not depend on how long a solve takes, to the last bit, only the time of
// their arrival does. Without a worker everything is done at once.
//
// Nothing here ever waits for the worker. At most one solve is owed, after a stated entry of the ring: a later one takes
// its place at once. Where the ring is full, samples are dropped and counted: the core sees the gap in their sequence and
// splits the window, as with any missed sample. A level begins only where its end will find room, else it is left out
// with all its samples. A reset empties the ring.
//
// A solve that outlasts the ring costs a gap, behind which filters settle anew, and one after the other would leave nothing to
// estimate from. So a solve is put off while the ring has no room for what will come meanwhile, judged by the last one, and after
// a loss until half of what has come since is in windows.
#pragma once
#include <cstdint>

#include "firmware/estimator_core.hpp"
#include "hal/interface/worker.hpp"

namespace firmware {

class Estimation {
 public:
  struct Results {
    Estimates estimates;
    bool judge_asked = false;
  };

  // worker: nullptr where there is none. Both must outlive this.
  Estimation(const CoreConfiguration& configuration, hal::Worker* worker)
      : configuration_(configuration), worker_(worker), core_(configuration) {}

  // As in EstimatorCore.
  void reset();
  void begin_level();
  // True: the core has it already, and no channel was at a rail.
  bool push(const RawSample& sample) {
    if (!idle() || core_.merges_with(sample)) {
      wait(sample);
      return false;
    }
    core_.push(sample);
    return !core_.saturated();
  }
  void end_level();
  // judge: tell the diagnosis as well. off_rate: the samples come at another rate than the core takes them for.
  void solve(bool judge, bool off_rate = false);

  void begin_step(uint64_t now_ns) { now_ns_ = now_ns; }
  uint64_t now_ns() const { return now_ns_; }
  void go_on();  // once in a step where it is not idle: with what waits
  bool has_result() const { return fresh_; }
  bool take_result();  // true: results() are of a solve that has ended since the last call
  bool idle() const { return !busy_; }
  // What runs on the worker has been running for longer than anything can.
  bool late() const { return working_ && now_ns_ - begun_ns_ > kLongestWork_ns; }
  // The longest solve, 16 DOF and 48 unknowns over a full table, takes some seconds on the slowest board in use.
  static constexpr uint64_t kLongestWork_ns = 20000000000;

  const Results& results() const { return results_; }
  uint32_t dropped_samples() const { return dropped_samples_; }
  CoreHealth health() const { return working_ ? health_ : core_.health(); }
  const EstimatorCore& core() const { return core_; }  // not while working

 private:
  enum class Kind : uint8_t { kReset, kBeginLevel, kEndLevel, kSolve, kSolveAndJudge, kSample };
  static constexpr int kKeptForOthers = 32;  // places that samples do not take
  // After a solve what waited is caught up with: in a step this many more than came since the last one. A sample with
  // its score tests costs a tenth of a millisecond on a small board, and the step has to fit its period.
  static constexpr int kCatchUp = 3;
  static_assert(kMaxWaiting > kKeptForOthers, "see FIRMWARE_MAX_WAITING");

  void ask(Kind kind);
  void wait(const RawSample& sample);
  void note_loss();
  RawSample& append(Kind kind);
  // sample: of kSample.
  void perform(Kind kind, const RawSample& sample);  // here or on the worker
  bool takes_long(Kind kind, const RawSample& sample) const;
  void run(Kind kind, const RawSample& sample);
  void finish();
  bool puts_off() const;                                                // the solve that is owed
  void note_busy() { busy_ = working_ || count_ != 0 || solve_owed_; }  // wherever one of them may have changed
  void catch_up();
  static void work(void* self);

  const CoreConfiguration& configuration_;
  hal::Worker* worker_;
  bool busy_ = false;     // something runs, waits or is owed
  bool working_ = false;  // the core belongs to the worker
  bool discard_ = false;  // what runs has been forgotten meanwhile
  bool fresh_ = false;
  bool solve_owed_ = false, judge_owed_ = false, off_rate_ = false;
  bool level_left_out_ = false;  // its samples are dropped
  int first_ = 0, count_ = 0;
  int came_ = 0;                                // entries of the ring since the last go_on()
  int before_solve_ = 0;                        // entries of the ring that come before it
  int count_at_begin_ = 0, came_in_solve_ = 0;  // entries when the job began; how many came during the last solve
  bool lost_ = false;                           // samples of the level, since put_off_until_ was set
  uint32_t put_off_until_ = 0;                  // so many samples has the core had before the next solve
  uint32_t dropped_samples_ = 0;
  uint64_t now_ns_ = 0, begun_ns_ = 0;
  CoreHealth health_;        // when it was begun
  Kind job_ = Kind::kReset;  // what the worker does, and with which sample
  RawSample job_sample_;
  Results results_;
  EstimatorCore core_;
  Kind kind_[kMaxWaiting] = {};  // the ring
  RawSample sample_[kMaxWaiting];
};

}  // namespace firmware
