#include "firmware/conditioning/conditioning.hpp"

#include "firmware/conditioning/filter_sum.hpp"
#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

constexpr int32_t kSignalLimit = 1 << 23;
// Of the high-pass, until what a level started with is forgotten. A double integration turns a start in mid-motion into
// metres: t^2 exp(-t / tau) must fall below 1e-5 of it, which takes 16 time constants. What is integrated once has no such start
// (high_passed()).
constexpr int settling_time_constants(int order) { return order > 2 ? 16 : 1; }

// log2 of how much lower the corner of the velocity is whose sign friction has.
constexpr int kLowerSignCorner = 3;
// Of the fusion's corner, until the noise of the slope that it started with is forgotten; the corner comes down step by step
// (starting_leak), four time constants each.
constexpr int kFusionTimeConstants = 2;

int32_t clamp32(int64_t value) {
  if (value > INT32_MAX) return INT32_MAX;
  if (value < -INT32_MAX) return -INT32_MAX;
  return static_cast<int32_t>(value);
}

// A rail as the signal's 24 bits about the offset allow it.
int32_t within(int32_t rail, int64_t offset) {
  const int64_t lowest = offset - kSignalLimit, highest = offset + kSignalLimit;
  return clamp32(rail < lowest ? lowest : rail > highest ? highest : rail);
}

int32_t between(int32_t lowest, int32_t code, int32_t highest) {
  return code < lowest ? lowest : code > highest ? highest : code;
}

// A pole that starts fast and comes down to 1 - 2^-leak_shift: what a level starts with is forgotten within its own length.
int starting_leak(uint32_t samples, int leak_shift) {
  int leak = 1;
  while (leak < leak_shift && (samples / 4 + 2) >> (leak + 1) != 0) ++leak;
  return leak;
}

}  // namespace

void Conditioning::configure(const CoreConfiguration& configuration) {
  configuration_ = &configuration;
  path_count_ = channel_count_ = reach_ = 0;
  for (int node = 0; node < kMaxNodes; ++node) {
    if (node >= configuration.dof_count && !(node == kBaseNode && configuration.base_present)) continue;
    for (int quantity = 0; quantity < kQuantities; ++quantity)
      if (configuration.channels[node][quantity].present) add_channel(node, quantity);
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const SignalConfiguration& signal = configuration.signals[node][quantity];
      if (!signal.available) continue;
      add_path(node, quantity, signal_column(node, static_cast<Quantity>(quantity)));
      if (signal.half_length > reach_) reach_ = signal.half_length;
    }
    if (kDerivesSignals && configuration.filters_sign()) add_sign_velocity(node);
  }
  alike_ = true;
  for (int c = 1; c < channel_count_; ++c)
    alike_ = alike_ && channel_[c].inside == channel_[0].inside && channel_[c].count == channel_[0].count;
  FIRMWARE_PRECONDITION(2 * reach_ + configuration.sign_half_length < kHistory);
  reach_ += configuration.sign_half_length;
  history_samples_ = 2 * reach_;
  if (configuration.high_pass_order > 0)
    history_samples_ += settling_time_constants(configuration.high_pass_order) << configuration.high_pass_shift;
  if (kDerivesSignals) link_fused_paths();
  plain_ = configuration.high_pass_order == 0;
  for (int i = 0; i < path_count_; ++i) {
    const SignalConfiguration& signal = signal_of(path_[i]);
    if (signal.half_length > 0 || signal.tap[0].raw != 0) plain_ = false;
  }
  if (kDerivesSignals) share_histories();
  restart();
}

void Conditioning::add_channel(int node, int quantity) {
  const ChannelConfiguration& configured = configuration_->channels[node][quantity];
  Channel& channel = channel_[channel_count_++];
  channel.place = static_cast<uint16_t>(node * kQuantities + quantity);
  channel.column = static_cast<uint16_t>(channel.place * kFrameStride);
  channel.offset = configured.offset_code;
  channel.lowest = within(configured.lowest_code, configured.offset_code);
  channel.highest = within(configured.highest_code, configured.offset_code);
  channel.inside = channel.lowest + 1;
  const int64_t count = int64_t{channel.highest} - channel.inside;
  channel.count = count > 0 ? static_cast<uint32_t>(count) : 0;
}

Conditioning::Path& Conditioning::add_path(int node, int quantity, int column) {
  const SignalConfiguration& signal = configuration_->signals[node][quantity];
  Path& path = path_[path_count_++];
  path.signal = static_cast<uint8_t>(node * kQuantities + quantity);
  path.channel_column = channel_[0].column;
  for (int c = 0; c < channel_count_; ++c)
    if (channel_[c].place == node * kQuantities + signal.source) path.channel_column = channel_[c].column;
  path.column = static_cast<uint16_t>(column * kFrameStride);
  path.sections = configuration_->high_pass_order;
  path.integrations = signal.integrations;
  path.shift = configuration_->high_pass_shift;
  return path;
}

void Conditioning::add_sign_velocity(int node) {
  const int velocity = static_cast<int>(Quantity::kVelocity);
  if (!configuration_->signals[node][velocity].available) return;
  Path& path = add_path(node, velocity, kSignVelocityColumn + node);
  if (configuration_->high_pass_order == 0) return;
  path.sections = path.integrations > 0 ? 2 : 0;
  path.shift = static_cast<uint8_t>(path.shift + kLowerSignCorner);
}

void Conditioning::link_fused_paths() {
  int settling = 0;
  for (int i = 0; i < path_count_; ++i) {
    Path& path = path_[i];
    const FusionConfiguration& fusion = configuration_->fusion[node_of(path)];
    path.partner = kNone;
    if (!fusion.used || !is(Quantity::kVelocity, path)) continue;
    for (int j = 0; j < path_count_; ++j)
      if (node_of(path_[j]) == node_of(path) && is(Quantity::kAcceleration, path_[j]))
        path.partner = static_cast<uint8_t>(j);
    const int needed = kFusionTimeConstants << fusion.leak_shift;
    if (needed > settling) settling = needed;
  }
  history_samples_ += settling;
}

void Conditioning::restart() {
  received_ = 0;
  saturated_ = false;
  history_at_ = 0;
  for (int i = 0; i < path_count_; ++i)
    for (int s = 0; s < kMaxSections; ++s) path_[i].section[s] = path_[i].previous[s] = State{};
  for (FusionState& fusion : fusion_) fusion = FusionState{};
}

// Without a high-pass every path of a channel would keep the same samples.
void Conditioning::share_histories() {
  for (int i = 0; i < path_count_; ++i) {
    Path& path = path_[i];
    path.history_of = static_cast<uint8_t>(i);
    for (int j = i - 1; j >= 0 && path.sections == 0; --j)
      if (path_[j].channel_column == path.channel_column && path_[j].sections == 0)
        path.history_of = static_cast<uint8_t>(j);
    path.history = static_cast<uint16_t>(i * 2 * kHistory);
    path.window = static_cast<uint16_t>(path.history_of * 2 * kHistory + kHistory - (reach_ - early(path)));
    const int parity = parity_of(signal_of(path).tap, signal_of(path).half_length);
    path.parity = static_cast<int8_t>(path.sections == 0 ? parity : 0);  // integrals have no bit left for a sum
    path.turn = static_cast<uint8_t>(path.partner != kNone ? kFused : kAlone);
    if (path.history_of == i) path.turn = static_cast<uint8_t>(path.turn | kKeepsHistory);
  }
  for (int i = 0; i < path_count_; ++i) delay_velocity(i);
  for (int i = 0; i + 1 < path_count_; ++i) share_pass(path_[i], path_[i + 1]);
  for (int i = 0; i + 2 < path_count_; ++i) share_even_pass(i, i + 2);
  list_turns();
}

void Conditioning::list_turns() {
  keep_count_ = work_count_ = 0;
  for (int i = 0; i < path_count_; ++i) {
    if (path_[i].turn & kKeepsHistory) keeps_[keep_count_++] = static_cast<uint8_t>(i);
    if (path_[i].turn & (kAlone | kWithNext | kWithEven | kFused | kDelayed))
      works_[work_count_++] = static_cast<uint8_t>(i);
  }
}

// Where no high-pass stands before them, a velocity and the one that its sign is taken from differ in their time alone.
void Conditioning::delay_velocity(int number) {
  Path& path = path_[number];
  if (!is(Quantity::kVelocity, path) || early(path) > 0 || path.turn & kFused) return;
  for (int j = 0; j < path_count_; ++j) {
    Path& sign = path_[j];
    if (early(sign) == 0 || node_of(sign) != node_of(path) || sign.history_of != path.history_of ||
        sign.history_of == j)
      continue;
    path.turn = static_cast<uint8_t>((path.turn & kKeepsHistory) | kDelayed);
    path.window = static_cast<uint16_t>(sign.history + kHistory - configuration_->sign_half_length);
    sign.turn = static_cast<uint8_t>(sign.turn | kKeepsOutput);
  }
}

void Conditioning::share_pass(Path& velocity, Path& acceleration) const {
  const bool neighbours = is(Quantity::kVelocity, velocity) && node_of(acceleration) == node_of(velocity) &&
                          acceleration.column == velocity.column + kFrameStride;
  const bool alike = acceleration.history_of == velocity.history_of &&
                     signal_of(acceleration).half_length == signal_of(velocity).half_length &&
                     early(velocity) == early(acceleration);
  if (!neighbours || !alike || velocity.parity != -1 || acceleration.parity != 1 || !(velocity.turn & kAlone)) return;
  velocity.turn = static_cast<uint8_t>((velocity.turn & kKeepsHistory) | kWithNext);
  acceleration.turn = static_cast<uint8_t>(acceleration.turn & kKeepsHistory);
}

// Displacement and acceleration, with the velocity of the same channel between them.
void Conditioning::share_even_pass(int number, int other) {
  Path &displacement = path_[number], &acceleration = path_[other];
  const bool same = node_of(displacement) == node_of(acceleration) &&
                    displacement.history_of == acceleration.history_of && early(displacement) == early(acceleration);
  const bool even = displacement.parity == 1 && acceleration.parity == 1 &&
                    signal_of(displacement).half_length <= signal_of(acceleration).half_length;
  if (!same || !even || !(displacement.turn & kAlone) || !(acceleration.turn & kAlone)) return;
  displacement.turn = static_cast<uint8_t>(displacement.turn & kKeepsHistory);
  acceleration.turn = static_cast<uint8_t>((acceleration.turn & kKeepsHistory) | kWithEven);
  acceleration.partner = static_cast<uint8_t>(number);
}

template <bool kAlike>
bool Conditioning::copy_codes(const int32_t* code, int32_t* column) const {
  bool saturated = false;
  const uint32_t inside = static_cast<uint32_t>(channel_->inside), count = channel_->count;
#pragma GCC unroll 2
  for (const Channel *c = channel_, *end = channel_ + channel_count_; c != end; ++c) {
    const int32_t value = code[c->place];
    const uint32_t above = static_cast<uint32_t>(value) - (kAlike ? inside : static_cast<uint32_t>(c->inside));
    if (above < (kAlike ? count : c->count)) {
      column[c->column] = value - c->offset;
    } else {
      saturated = true;
      column[c->column] = centred(*c, value).raw;
    }
  }
  return saturated;
}

bool Conditioning::append(const RawSample& sample, Frame& frame, int at) {
  FIRMWARE_PRECONDITION(configuration_ != nullptr && at >= 0 && at < kFrameStride);
  static_assert(signal_column(1, Quantity::kForce) == kQuantities, "channels and signal columns are numbered alike");
  const int32_t* code = &sample.code[0][0];
  int32_t* column = &frame.raw[0][at];
  saturated_ = alike_ ? copy_codes<true>(code, column) : copy_codes<false>(code, column);
  return !kDerivesSignals || plain_ || filter(frame, at);
}

void Conditioning::move_frame(Frame& frame, int count, int kept) const {
  for (const Path *path = path_, *end = path_ + path_count_; path != end; ++path) {
    int32_t* to = &frame.raw[0][0] + path->column;
    const int32_t* from = to + count;
    for (const int32_t* last = from + kept; from != last;) *to++ = *from++;
  }
}

Code Conditioning::centred(const Channel& channel, int32_t code) {
  return Code::from_raw(between(channel.lowest, code, channel.highest) - channel.offset);
}

// sum / 2^shift to nearest; |sum| < 2^62.
int64_t shifted_to_nearest(int64_t sum, int shift) {
  return shift > 0 ? (sum + (int64_t{1} << (shift - 1))) >> shift : sum;
}

// What a filter gives while it fills is not saturated, nor is the velocity that only friction's sign is taken from.
[[gnu::noinline]] Code Conditioning::clipped(bool high, const Path& path) {
  if (!for_sign(path) && received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;
  return Code::from_raw(high ? kSignalLimit : -kSignalLimit);
}

// Of shifts from 32 bits on, the usual ones, the upper word and at most a bit of the lower one are needed.
inline Code Conditioning::rounded(int64_t sum, int shift, const Path& path) {
  int64_t value;
  if (shift >= 32) {
    const auto high = static_cast<int32_t>(sum >> 32);
    const auto bit = static_cast<int32_t>(static_cast<uint32_t>(sum) >> 31);
    const int32_t nearest = shift == 32 ? high + bit : (high + (int32_t{1} << (shift - 33))) >> (shift - 32);
    if (nearest <= kSignalLimit && nearest >= -kSignalLimit) return Code::from_raw(nearest);
    value = nearest;
  } else {
    value = shifted_to_nearest(sum, shift);
    if (value <= kSignalLimit && value >= -kSignalLimit) return Code::from_raw(static_cast<int32_t>(value));
  }
  return clipped(value > 0, path);
}

// The sign's velocity of some samples ago; at its limit it is taken for saturated.
inline Code Conditioning::delayed(Code value) {
  const bool at_limit = value.raw >= kSignalLimit || value.raw <= -kSignalLimit;
  if (at_limit && received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;
  return value;
}

// What a filter or two give: signals, those of the configuration; column, the frame's at the sample.
[[gnu::always_inline]] inline void Conditioning::work_on(const Path& path, const SignalConfiguration* signals,
                                                         const Code* middle, int32_t* column) {
  const SignalConfiguration& signal = signals[path.signal];
  int32_t& place = column[path.column];
  if (path.turn & kAlone) {
    const Code value = rounded(filter_sum(path.parity, signal.tap, middle, signal.half_length), signal.shift, path);
    place = value.raw;
    if (path.turn & kKeepsOutput) keep(&history_[path.history + history_at_], value);
  } else if (path.turn & kWithEven) {  // and the displacement's
    const Path& displacement = path_[path.partner];
    const SignalConfiguration& x = signals[displacement.signal];
    const TwoEven sum = two_even_sums(x.tap, x.half_length, signal.tap, signal.half_length, middle);
    column[displacement.column] = rounded(sum.shorter, x.shift, displacement).raw;
    place = rounded(sum.longer, signal.shift, path).raw;
  } else {  // the acceleration's filter stands behind the velocity's
    const SignalConfiguration& a = (&signal)[1];
    const OddAndEven sum = odd_and_even_sum(signal.tap, a.tap, middle, signal.half_length);
    place = rounded(sum.odd, signal.shift, path).raw;
    (&place)[kFrameStride] = rounded(sum.even, a.shift, path).raw;
  }
}

bool Conditioning::filter(Frame& frame, int at) {
  int32_t* const column = &frame.raw[0][at];
  Code* const newest = &history_[history_at_];
  const SignalConfiguration* const signals = &configuration_->signals[0][0];
  for (const uint8_t *i = keeps_, *end = keeps_ + keep_count_; i != end; ++i) {
    Path& path = path_[*i];
    const Code code = Code::from_raw(column[path.channel_column]);
    keep(newest + path.history, path.sections == 0 ? code : high_passed(path, code));
  }
  for (const uint8_t *i = works_, *end = works_ + work_count_; i != end; ++i) {
    const Path& path = path_[*i];
    const Code* const middle = newest + path.window;
    int32_t& place = column[path.column];
    if (path.turn & kDelayed)
      place = delayed(*middle).raw;
    else if (path.turn & kFused)
      place = fused(path).raw;
    else
      work_on(path, signals, middle, column);
  }
  if (++history_at_ == kHistory) history_at_ = 0;
  ++received_;
  return received_ > static_cast<uint32_t>(history_samples_);
}

// The first slope is taken to have stood there for ever.
Code Conditioning::fused(const Path& path) {
  const SignalConfiguration& signal = signal_of(path);
  const FusionConfiguration& fusion = configuration_->fusion[node_of(path)];
  FusionState& state = fusion_[kDerivesSignals ? node_of(path) : 0];
  const int half = signal.half_length, middle = history_at_ + kHistory - reach_;
  const int acceleration = path_[path.partner].history_of;
  const int64_t slope = filter_sum(0, signal.tap, &history_[path.history_of * 2 * kHistory + middle], half);
  const int64_t step = filter_sum(0, fusion.step_tap, &history_[acceleration * 2 * kHistory + middle], half);
  if (received_ + 1 < static_cast<uint32_t>(2 * reach_ + 1)) return {};
  if (received_ + 1 == static_cast<uint32_t>(2 * reach_ + 1)) state.slope = slope;
  const int leak = starting_leak(received_ - static_cast<uint32_t>(2 * reach_), fusion.leak_shift);
  const int64_t before = state.once;
  state.once += step - (slope - state.slope) - (state.once >> leak);
  state.twice += state.once - before - (state.twice >> leak);
  state.slope = slope;
  return rounded(slope + state.twice, signal.shift, path);
}

// First-order sections with the pole 1 - 2^-shift. The differences come first, they take the offset away before the
// integrations sum anything; the very first sample is taken to have stood there for ever, so there is no switch-on
// step.
//
// A leaking integral of the velocity from the first sample on is exactly the first difference section of the displacement:
// x[n] - x[n - 1] is what it adds. So where a displacement comes from a measured velocity the integration is first, and all
// signals' sections start alike. (Differences first would take v[0] for rest: v[0] t exp(-t / tau) in the displacement, at
// 10 Hz and after four time constants of 0.8 s still three times the motion.) The integral begins at the first sample: half of it.
Code Conditioning::high_passed(Path& path, Code code) const {
  const int shift = for_sign(path) ? starting_leak(received_, path.shift) : path.shift;
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
  return Code::from_raw(clamp32(rescale<Fixed<int64_t, 0>>(value).raw));
}

}  // namespace firmware
