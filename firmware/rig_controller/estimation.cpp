// See estimation.hpp.
#include "firmware/rig_controller/estimation.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {

void Estimation::reset() {
  discard_ = working_;
  fresh_ = false;
  solve_owed_ = level_left_out_ = false;
  count_ = 0;
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
    return;
  }
  append(Kind::kSample).sample = sample;
  if (!working_ && count_ == 1) go_on();
}

void Estimation::solve(bool judge) {
  judge_owed_ = judge || (solve_owed_ && judge_owed_);
  solve_owed_ = true;
  before_solve_ = count_;
  if (!working_ && count_ == 0) go_on();
}

void Estimation::ask(Kind kind) {
  if (idle()) {
    Entry entry;
    entry.kind = kind;
    return perform(entry);
  }
  append(kind);
}

Estimation::Entry& Estimation::append(Kind kind) {
  FIRMWARE_PRECONDITION(count_ < kMaxWaiting);
  Entry& entry = ring_[(first_ + count_) % kMaxWaiting];
  ++count_;
  ++came_;
  entry.kind = kind;
  return entry;
}

void Estimation::go_on() {
  if (working_ && worker_->done()) finish();
  const int came = came_, most = came + kCatchUp;
  came_ = 0;
  for (int taken = 0; taken < most && !working_; ++taken) {
    // A block's two halves are for two steps, in catching up too.
    if (taken >= came && taken > 0 && core_.owes_sums()) return;
    if (solve_owed_ && before_solve_ == 0) {
      solve_owed_ = false;
      Entry solve;
      solve.kind = judge_owed_ ? Kind::kSolveAndJudge : Kind::kSolve;
      perform(solve);
      continue;
    }
    if (count_ == 0) return;
    const int place = first_;
    first_ = (first_ + 1) % kMaxWaiting;
    --count_;
    if (solve_owed_) --before_solve_;
    perform(ring_[place]);
  }
}

bool Estimation::take_result() {
  const bool fresh = fresh_;
  fresh_ = false;
  return fresh;
}

bool Estimation::takes_long(const Entry& entry) const {
  switch (entry.kind) {
    case Kind::kSolve:
    case Kind::kSolveAndJudge:
      return true;
    case Kind::kSample:
      return core_.merges_with(entry.sample);
    case Kind::kEndLevel:
    case Kind::kBeginLevel:
      return core_.merges_at_end();
    case Kind::kReset:
      return false;
  }
  return false;
}

void Estimation::perform(const Entry& entry) {
  if (!takes_long(entry)) return run(entry);
  job_ = entry;
  health_ = core_.health();
  discard_ = false;
  working_ = true;
  begun_ns_ = now_ns_;
  if (worker_ != nullptr) return worker_->start(&Estimation::work, this);
  work(this);
  finish();
}

void Estimation::work(void* self) {
  auto& own = *static_cast<Estimation*>(self);
  own.run(own.job_);
}

void Estimation::run(const Entry& entry) {
  switch (entry.kind) {
    case Kind::kReset:
      return core_.reset();
    case Kind::kBeginLevel:
      return core_.begin_level();
    case Kind::kEndLevel:
      return core_.end_level();
    case Kind::kSample:
      return core_.push(entry.sample);
    case Kind::kSolve:
    case Kind::kSolveAndJudge:
      core_.solve();
      return;
  }
}

void Estimation::finish() {
  working_ = false;
  if (discard_ || (job_.kind != Kind::kSolve && job_.kind != Kind::kSolveAndJudge)) return;
  fresh_ = true;
  results_.estimates = core_.estimates();
  results_.judge_asked = job_.kind == Kind::kSolveAndJudge;
}

}  // namespace firmware
