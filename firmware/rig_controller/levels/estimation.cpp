// See estimation.hpp.
#include "firmware/rig_controller/levels/estimation.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

// Every coefficient but a stiffness has a time in its unit, and a stiffness its share of errors. Where nothing was estimated it stays so.
void believe_no_time(Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k) {
    EstimateStatus& status = estimates.parameters[k].status;
    if (status != EstimateStatus::kStale && severity(status) < severity(EstimateStatus::kSkewed))
      status = EstimateStatus::kSkewed;
  }
}

}  // namespace

void Estimation::reset() {
  discard_ = working_;
  fresh_ = false;
  solve_owed_ = level_left_out_ = lost_ = false;
  count_ = 0;
  note_busy();
  ask(Kind::kReset);
}

void Estimation::begin_level() {
  level_left_out_ = count_ + 2 > kMaxWaiting;  // itself and its end
  if (!level_left_out_) ask(Kind::kBeginLevel);
}

void Estimation::end_level() {
  if (!level_left_out_) ask(Kind::kEndLevel);
  level_left_out_ = false;
}

void Estimation::wait(const RawSample& sample) {
  if (level_left_out_ || count_ >= kMaxWaiting - kKeptForOthers) {
    ++dropped_samples_;
    if (!level_left_out_) note_loss();
    return;
  }
  append(Kind::kSample) = sample;
  if (!working_ && count_ == 1) go_on();
}

// Behind the gap a level's margin settles the filters, and as many samples again are measured.
void Estimation::note_loss() {
  lost_ = true;
  put_off_until_ = health().samples + static_cast<uint32_t>(count_ + 2 * core_.margin_samples());
}

bool Estimation::puts_off() const {
  if (lost_ && static_cast<int32_t>(put_off_until_ - core_.health().samples) > 0) return true;
  return count_ != 0 && count_ + came_in_solve_ > kMaxWaiting - kKeptForOthers;
}

void Estimation::solve(bool judge, bool off_rate) {
  off_rate_ = off_rate;
  judge_owed_ = judge || (solve_owed_ && judge_owed_);
  solve_owed_ = true;
  before_solve_ = count_;
  note_busy();
  if (!working_ && count_ == 0) go_on();
}

void Estimation::ask(Kind kind) {
  if (!idle()) {
    append(kind);
    return;
  }
  perform(kind, job_sample_);
  note_busy();
}

RawSample& Estimation::append(Kind kind) {
  FIRMWARE_PRECONDITION(count_ < kMaxWaiting);
  const int place = (first_ + count_) % kMaxWaiting;
  ++count_;
  ++came_;
  busy_ = true;
  kind_[place] = kind;
  return sample_[place];
}

void Estimation::go_on() {
  catch_up();
  note_busy();
}

void Estimation::catch_up() {
  if (working_ && worker_->done()) finish();
  const int came = came_, most = came + kCatchUp;
  came_ = 0;
  for (int taken = 0; taken < most && !working_; ++taken) {
    // A block's two halves are for two steps, in catching up too.
    if (taken >= came && taken > 0 && core_.owes_sums()) return;
    if (solve_owed_ && before_solve_ == 0 && !puts_off()) {
      solve_owed_ = lost_ = false;
      perform(judge_owed_ ? Kind::kSolveAndJudge : Kind::kSolve, job_sample_);
      continue;
    }
    if (count_ == 0) return;
    const int place = first_;
    first_ = (first_ + 1) % kMaxWaiting;
    --count_;
    if (solve_owed_ && before_solve_ > 0) --before_solve_;
    perform(kind_[place], sample_[place]);
  }
}

bool Estimation::take_result() {
  const bool fresh = fresh_;
  fresh_ = false;
  return fresh;
}

bool Estimation::takes_long(Kind kind, const RawSample& sample) const {
  switch (kind) {
    case Kind::kSolve:
    case Kind::kSolveAndJudge:
      return true;
    case Kind::kSample:
      return core_.merges_with(sample);
    case Kind::kEndLevel:
    case Kind::kBeginLevel:
      return core_.merges_at_end();
    case Kind::kReset:
      return false;
  }
  return false;
}

void Estimation::perform(Kind kind, const RawSample& sample) {
  if (kind == Kind::kEndLevel) lost_ = false;  // nothing comes that a solve could wait for
  if (!takes_long(kind, sample)) return run(kind, sample);
  job_ = kind;
  if (kind == Kind::kSample) job_sample_ = sample;
  health_ = core_.health();
  discard_ = false;
  working_ = true;
  count_at_begin_ = count_;
  begun_ns_ = now_ns_;
  if (worker_ != nullptr) return worker_->start(&Estimation::work, this);
  work(this);
  finish();
}

void Estimation::work(void* self) {
  auto& own = *static_cast<Estimation*>(self);
  own.run(own.job_, own.job_sample_);
}

void Estimation::run(Kind kind, const RawSample& sample) {
  switch (kind) {
    case Kind::kReset:
      return core_.reset();
    case Kind::kBeginLevel:
      return core_.begin_level();
    case Kind::kEndLevel:
      return core_.end_level();
    case Kind::kSample:
      return core_.push(sample);
    case Kind::kSolve:
    case Kind::kSolveAndJudge:
      core_.solve();
      return;
  }
}

void Estimation::finish() {
  working_ = false;
  if (discard_ || (job_ != Kind::kSolve && job_ != Kind::kSolveAndJudge)) return;
  fresh_ = true;
  came_in_solve_ = count_ - count_at_begin_;
  results_.estimates = core_.estimates();
  if (off_rate_) believe_no_time(results_.estimates);
  results_.judge_asked = job_ == Kind::kSolveAndJudge;
}

}  // namespace firmware
