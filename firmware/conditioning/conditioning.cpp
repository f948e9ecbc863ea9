#include "firmware/conditioning/conditioning.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

int32_t between(int32_t lowest, int32_t code, int32_t highest) {
  return code < lowest ? lowest : code > highest ? highest : code;
}

constexpr uint32_t kSlopeTimeConstants = 4, kStartTimeConstants = 1;
constexpr int kOnceSections = 2;               // of a high-pass where nothing is integrated twice
constexpr uint32_t kMostReceived = INT32_MAX;  // a level may be longer; every filter has settled long before

}  // namespace

int starting_leak(uint32_t samples, int leak_shift, uint32_t time_constants) {
  int leak = 1;
  while (leak < leak_shift && samples / time_constants >= (2u << leak) - 2) ++leak;
  return leak;
}

void Conditioning::restart() {
  received_ = 0;
  saturated_ = false;
  history_at_ = waits_at_ = 0;
  limits_ = 0;
  shift_.restart();
  for (int i = 0; i < path_count_; ++i)
    for (int s = 0; s < kMaxSections; ++s) path_[i].section[s] = path_[i].previous[s] = State{};
  for (FusionState& fusion : fusion_) fusion = FusionState{};
}

[[gnu::noinline]] bool Conditioning::copy_each(const int32_t* code, int32_t* column) const {
  bool saturated = false;
  for (int c = 0; c < channel_count_; ++c) {
    const Channel& channel = channel_[c];
    int32_t value = code[place_[c].code];
    if (static_cast<uint32_t>(value) - static_cast<uint32_t>(channel.inside) >= channel.count) {
      value = between(channel.inside - 1, value, channel.inside + static_cast<int32_t>(channel.count));
      saturated = true;
    }
    column[place_[c].column] = value - channel.offset;
  }
  return saturated;
}

// The usual case: all channels alike, and no code at a rail. Two at a time; of an odd number the last one comes twice.
inline bool Conditioning::copy_alike(const int32_t* code, int32_t* column) const {
  const uint32_t inside = static_cast<uint32_t>(channel_->inside), count = channel_->count;
  const int32_t offset = channel_->offset;
  const Place *place = place_, *const end = place_ + alike_count_;
  if (place == end) return false;
  do {
    const int32_t one = code[place[0].code], other = code[place[1].code];
    if (static_cast<uint32_t>(one) - inside >= count || static_cast<uint32_t>(other) - inside >= count) return false;
    column[place[0].column] = one - offset;
    column[place[1].column] = other - offset;
    place += 2;
  } while (place != end);
  return true;
}

bool Conditioning::append(const RawSample& sample, Frame& frame, int at) {
  FIRMWARE_PRECONDITION(configuration_ != nullptr && at >= 0 && at < kFrameStride);
  static_assert(signal_column(1, Quantity::kForce) == kQuantities, "channels and signal columns are numbered alike");
  const int32_t* code = &sample.code[0][0];
  int32_t* column = &frame.raw[0][at];
  saturated_ = !copy_alike(code, column) && copy_each(code, column);
  return copies_alone_ || derive(column);
}

bool Conditioning::derive(int32_t* column) {
  if (shifts_ && !shift_channels(column)) return false;
  return !kDerivesSignals || plain_ || filter(column);
}

[[gnu::noinline]] bool Conditioning::shift_channels(int32_t* column) {
  return shift_.shift(
      channel_count_, [&](int c) -> int32_t& { return column[place_[c].column]; }, saturated_);
}

void Conditioning::move_frame(Frame& frame, int count, int kept) const {
  for (const Path *path = path_, *end = path_ + path_count_; path != end; ++path) {
    int32_t* to = &frame.raw[0][0] + path->column;
    const int32_t* from = to + count;
    for (const int32_t* last = from + kept; from != last;) *to++ = *from++;
  }
}

// What a filter gives while it fills is not saturated, nor is the velocity that only friction's sign is taken from.
[[gnu::noinline]] Code Conditioning::clipped(bool high, bool counts) {
  if (counts && received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;
  return Code::from_raw(high ? kSignalLimit : -kSignalLimit);
}

inline Code Conditioning::within_limit(Code value, bool counts) {
  return value.raw <= kSignalLimit && value.raw >= -kSignalLimit ? value : clipped(value.raw > 0, counts);
}

// What came early, some samples ago; at its limit it is taken for saturated.
inline Code Conditioning::delayed(Code value) {
  const bool at_limit = value.raw >= kSignalLimit || value.raw <= -kSignalLimit;
  if (at_limit && received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;
  return value;
}

// What a filter gives: signals, those of the configuration; column, the frame's at the sample.
[[gnu::always_inline]] inline void Conditioning::work_on(const Path& path, Code* newest, int32_t* column) {
  const SignalConfiguration& signal = signal_of(path);
  const Code value = within_limit(filter_signal(signal, newest + path.window, path.parity), !for_sign(path));
  column[path.column] = value.raw;
  if (path.turn & kKeepsOutput) keep(newest + path.history, value);
}

// What is beyond the limit is clipped; at it, it counts as saturated when its time has come.
[[gnu::noinline]] void Conditioning::limit_waiting(Code* waiting) {
  for (Code* value = waiting; value != waiting + kWaiting; ++value) {
    if (value->raw < kSignalLimit && value->raw > -kSignalLimit) continue;
    *value = Code::from_raw(value->raw > 0 ? kSignalLimit : -kSignalLimit);
    limits_ |= 1;
  }
}

// Columns, paths and configurations of displacement, velocity and acceleration stand behind each other. Early ones, for friction's
// sign, wait where the velocity's history would be; those whose time has come take their places in the columns.
void Conditioning::work_on_early_threes(Code* newest, int32_t* column) {
  constexpr auto kFar = static_cast<uint32_t>(kSignalLimit - 1);  // bits alone tell that all three are nearer to zero
  const SignalConfiguration* const signals = &configuration_->signals[0][0];
  const auto to_waiting = &history_[2 * kHistory + waits_at_] - newest;
  limits_ <<= 1;
  for (const uint8_t *i = works_, *end = works_ + three_count_; i != end; ++i) {
    const Path* const path = path_ + *i;
    const SignalConfiguration* const signal = signals + path->signal;
    Code* const history = newest + path->history;
    keep(history, Code::from_raw(column[path->channel_column]));
    const Code* const middle = newest + path->window;
    Code* const waiting = history + to_waiting;
    int32_t* const place = column + path->column;
    uint32_t bits = 0;
    const auto exchange = [&](int q, Code value) {
      bits |= static_cast<uint32_t>(value.raw ^ (value.raw >> 31));
      place[q * kFrameStride] = waiting[q].raw;
      waiting[q] = value;
    };
    exchange(0, even_signal(signal[0], middle));
    exchange(1, odd_signal(signal[1], middle));
    exchange(2, even_signal(signal[2], middle));
    if (bits >= kFar) limit_waiting(waiting);
    column[path[1].window] = waiting[1].raw;
  }
  if (limits_ & limit_bit_ && received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;
  waits_at_ = waits_at_ + kWaiting < waiting_ ? waits_at_ + kWaiting : 0;
}

bool Conditioning::filter(int32_t* column) {
  Code* const newest = &history_[history_at_];
  for (const uint8_t *i = keeps_, *end = keeps_ + keep_count_; i != end; ++i) {
    Path& path = path_[*i];
    const Code code = Code::from_raw(column[path.channel_column]);
    keep(newest + path.history, path.sections == 0 ? code : high_passed(path, code));
  }
  if (three_count_ > 0) work_on_early_threes(newest, column);
  for (const uint8_t *i = works_ + three_count_, *end = works_ + work_count_; i != end; ++i) {
    const Path& path = path_[*i];
    if (!(path.turn & (kDelayed | kFused)))
      work_on(path, newest, column);
    else
      column[path.column] = (path.turn & kFused ? fused(path) : delayed(newest[path.window])).raw;
  }
  if (++history_at_ == kHistory) history_at_ = 0;
  if (received_ + 1 <= kMostReceived) ++received_;
  return received_ > static_cast<uint32_t>(history_samples_);
}

// The first slope is taken to have stood there for ever.
Code Conditioning::fused(const Path& path) {
  const SignalConfiguration& signal = signal_of(path);
  const FusionConfiguration& fusion = configuration_->fusion[node_of(path)];
  FusionState& state = fusion_[kDerivesSignals ? node_of(path) : 0];
  const int half = signal.half_length, middle = history_at_ + kHistory - reach_;
  const int acceleration = path_[path.partner].history_of;
  const int64_t slope = filter_sum(signal.tap, &history_[path.history_of * 2 * kHistory + middle], half);
  const int64_t step = filter_sum(fusion.step_tap, &history_[acceleration * 2 * kHistory + middle], half);
  if (received_ + 1 < static_cast<uint32_t>(2 * reach_ + 1)) return {};
  if (received_ + 1 == static_cast<uint32_t>(2 * reach_ + 1)) state.slope = slope;
  const int leak = starting_leak(received_ - static_cast<uint32_t>(2 * reach_), fusion.leak_shift, kSlopeTimeConstants);
  const int64_t before = state.once;
  state.once += step - (slope - state.slope) - (state.once >> leak);
  state.twice += state.once - before - (state.twice >> leak);
  state.slope = slope;
  return within_limit(nearest(slope + state.twice, signal.shift), !for_sign(path));
}

// Two sections H = (1 - z^-1) / (1 - p z^-1), p = 1 - 2^-shift, leave the velocity 2 / (w tau) ahead: its sign changes early, and that bends
// friction. 1 / H = 1 + 2^-shift z^-1 / (1 - z^-1), so twice such a sum undoes both to the first order. The sum leaks four times as fast as
// the sections: it is right for what moves above their corner. It begins when the next slower pole would be due: it would carry on what a level
// starts with, which is forgotten then.
Conditioning::State Conditioning::with_its_slow_part(Path& path, State velocity) const {
  constexpr int kFaster = 2;
  if (starting_leak(received_, path.shift + 1, kSlopeTimeConstants) <= path.shift) return velocity;
  State& sum = path.section[kSlowPart];
  const State whole = velocity + (1 << kSlowPartBits) * (sum >> (path.shift - 1));
  sum = sum + ((velocity >> kSlowPartBits) - (sum >> (path.shift - kFaster)));
  return whole;
}

// The plan drops as many bits as the largest value needs; what is cut off all the same is not what it stands for.
inline Code Conditioning::held(State value, const Path& path) {
  const int shift = State::kFractionBits + signal_of(path).dropped_bits;
  const int64_t whole = (value.raw + (int64_t{1} << (shift - 1))) >> shift;
  if (whole <= INT32_MAX && whole >= -INT32_MAX) return Code::from_raw(static_cast<int32_t>(whole));
  clipped(whole > 0, !for_sign(path));
  return Code::from_raw(whole > 0 ? INT32_MAX : -INT32_MAX);
}

// First-order sections with the pole 1 - 2^-shift. The differences come first, they take the offset away before the
// integrations sum anything; the very first sample is taken to have stood there for ever, so there is no switch-on
// step.
//
// A leaking integral of the velocity from the first sample on is exactly the first difference section of the displacement:
// x[n] - x[n - 1] is what it adds. So where a displacement comes from a measured velocity the integration is first, and all
// signals' sections start alike. (Differences first would take v[0] for rest: v[0] t exp(-t / tau) in the displacement, at
// 10 Hz and after four time constants of 0.8 s still three times the motion.) The integral begins at the first sample: half of it.
//
// All signals then obey the equation of motion from the first sample on, but the velocity is the slope of the displacement only
// once v[0] is forgotten: before, every displacement looks late or early. A pole that all signals share may change: each stays
// for one time constant on its way to the last, and little of v[0] is left where the first window begins.
Code Conditioning::high_passed(Path& path, Code code) {
  const int shift = for_sign(path)                   ? starting_leak(received_, path.shift, kSlopeTimeConstants)
                    : path.sections == kOnceSections ? starting_leak(received_, path.shift, kStartTimeConstants)
                                                     : path.shift;
  const bool first = integrates_first(path);
  const int integrate_from = first ? 0 : path.sections - path.integrations;
  State value = rescale<State>(code);
  if (received_ == 0) {
    path.previous[0] = value;
    if (first) value = value >> 1;
  }
  for (int s = 0; s < path.sections; ++s) {
    State& state = path.section[s];
    if (s >= integrate_from && s < integrate_from + path.integrations) {
      state = state + (value - (state >> shift));
      value = state >> (configuration_->high_pass_shift - kIntegrationExtraBits);
    } else {
      state = state + (value - path.previous[s] - (state >> shift));
      path.previous[s] = value;
      value = state;
    }
  }
  if (for_sign(path) && path.sections > 0) value = with_its_slow_part(path, value);
  return held(value, path);
}

}  // namespace firmware
