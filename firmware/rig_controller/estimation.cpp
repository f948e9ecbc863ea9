// See estimation.hpp.
#include "firmware/rig_controller/estimation.hpp"

namespace firmware {

void Estimation::reset() {
  discard_ = working_;
  fresh_ = false;
  if (waiting_solve_ >= 0) ring_[waiting_solve_].kind = Kind::kNothing;
  waiting_solve_ = -1;
  ask(Kind::kReset);
}

void Estimation::push(const RawSample& sample) {
  if (idle() && !core_.merges_with(sample)) return core_.push(sample);
  if (count_ >= kMaxWaiting - kKeptForOthers) {
    ++dropped_samples_;
    return;
  }
  append(Kind::kSample).sample = sample;
  if (!working_ && count_ == 1) advance();
}

// Anything but a sample must not be lost: where there is no room, it waits for the worker.
void Estimation::ask(Kind kind) {
  while (count_ == kMaxWaiting) {
    if (working_) worker_->wait();
    advance();
  }
  if (idle()) {
    Entry entry;
    entry.kind = kind;
    return perform(entry);
  }
  if (kind == Kind::kSolve || kind == Kind::kSolveAndJudge) return append_solve(kind);
  append(kind);
}

// In place of one that waits already.
void Estimation::append_solve(Kind kind) {
  if (waiting_solve_ >= 0) {
    if (ring_[waiting_solve_].kind == Kind::kSolveAndJudge) kind = Kind::kSolveAndJudge;
    ring_[waiting_solve_].kind = Kind::kNothing;
  }
  append(kind);
  waiting_solve_ = (first_ + count_ - 1) % kMaxWaiting;
}

Estimation::Entry& Estimation::append(Kind kind) {
  Entry& entry = ring_[(first_ + count_) % kMaxWaiting];
  ++count_;
  entry.kind = kind;
  return entry;
}

void Estimation::advance() {
  if (working_ && worker_->done()) finish();
  for (int taken = 0; taken < kSamplesPerAdvance && !working_ && count_ > 0; ++taken) {
    const int place = first_;
    if (place == waiting_solve_) waiting_solve_ = -1;
    first_ = (first_ + 1) % kMaxWaiting;
    --count_;
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
    case Kind::kNothing:
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
    case Kind::kNothing:
      return;
    case Kind::kReset:
      return core_.reset();
    case Kind::kBeginLevel:
      return core_.begin_level();
    case Kind::kEndLevel:
      return core_.end_level();
    case Kind::kSample:
      return core_.push(entry.sample);
    case Kind::kSolve:
      core_.solve();
      return;
    case Kind::kSolveAndJudge:
      judged_ = watch_.judge(configuration_, core_.table(), core_.solve(), judgement_);
      return;
  }
}

void Estimation::finish() {
  working_ = false;
  if (discard_ || (job_.kind != Kind::kSolve && job_.kind != Kind::kSolveAndJudge)) return;
  fresh_ = true;
  results_.estimates = core_.estimates();
  results_.judge_asked = job_.kind == Kind::kSolveAndJudge;
  results_.judged = judged_;
  results_.judgement = judgement_;
}

}  // namespace firmware
