#include "firmware/conditioning/conditioning.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

constexpr int32_t kSignalLimit = 1 << 23;
// Of the high-pass, until what a level started with is forgotten. A double integration turns a start in mid-motion into
// metres: t^2 exp(-t / tau) must fall below 1e-5 of it, which takes 16 time constants.
constexpr int settling_time_constants(int order) { return order > 2 ? 16 : 4; }

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
  FIRMWARE_PRECONDITION(2 * reach_ + configuration.sign_half_length < kHistory);
  reach_ += configuration.sign_half_length;
  history_samples_ = 2 * reach_;
  if (configuration.high_pass_order > 0)
    history_samples_ += settling_time_constants(configuration.high_pass_order) << configuration.high_pass_shift;
  link_fused_paths();
  plain_ = configuration.high_pass_order == 0;
  for (int i = 0; i < path_count_; ++i) {
    const SignalConfiguration& signal = configuration.signals[path_[i].node][path_[i].quantity];
    if (signal.half_length > 0 || signal.tap[0].raw != 0) plain_ = false;
  }
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
  path.node = static_cast<uint8_t>(node);
  path.quantity = static_cast<uint8_t>(quantity);
  path.channel = 0;
  for (int c = 0; c < channel_count_; ++c)
    if (channel_[c].place == node * kQuantities + signal.source) path.channel = static_cast<uint8_t>(c);
  path.column = static_cast<uint16_t>(column);
  path.sections = configuration_->high_pass_order;
  path.integrations = signal.integrations;
  path.shift = configuration_->high_pass_shift;
  return path;
}

void Conditioning::add_sign_velocity(int node) {
  const int velocity = static_cast<int>(Quantity::kVelocity);
  if (!configuration_->signals[node][velocity].available) return;
  Path& path = add_path(node, velocity, kSignVelocityColumn + node);
  path.early = configuration_->sign_half_length;
  if (configuration_->high_pass_order == 0) return;
  path.sections = path.integrations > 0 ? 2 : 0;
  path.shift = static_cast<uint8_t>(path.shift + kLowerSignCorner);
}

void Conditioning::link_fused_paths() {
  int settling = 0;
  for (int i = 0; i < path_count_; ++i) {
    Path& path = path_[i];
    const FusionConfiguration& fusion = configuration_->fusion[path.node];
    path.fused_with = -1;
    if (!fusion.used || path.quantity != static_cast<int>(Quantity::kVelocity)) continue;
    for (int j = 0; j < path_count_; ++j)
      if (path_[j].node == path.node && path_[j].quantity == static_cast<int>(Quantity::kAcceleration))
        path.fused_with = static_cast<int16_t>(j);
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

bool Conditioning::append(const RawSample& sample, Frame& frame, int at) {
  FIRMWARE_PRECONDITION(configuration_ != nullptr && at >= 0 && at < kFrameStride);
  static_assert(signal_column(1, Quantity::kForce) == kQuantities, "channels and signal columns are numbered alike");
  const int32_t* code = &sample.code[0][0];
  int32_t* column = &frame.raw[0][at];
  saturated_ = false;
  for (const Channel *c = channel_, *end = channel_ + channel_count_; c != end; ++c) {
    const int32_t value = code[c->place];
    if (static_cast<uint32_t>(value) - static_cast<uint32_t>(c->inside) < c->count) {
      column[c->column] = value - c->offset;
    } else {
      saturated_ = true;
      column[c->column] = centred(*c, value).raw;
    }
  }
  return plain_ || filter(sample, frame, at);
}

bool Conditioning::filter(const RawSample& sample, Frame& frame, int at) {
  for (int i = 0; i < path_count_; ++i) {
    Path& path = path_[i];
    const Channel& channel = channel_[path.channel];
    const int32_t code = (&sample.code[0][0])[channel.place];
    frame.codes(path.column).put(at, filtered(path, centred(channel, code)));
  }
  for (int i = 0; i < path_count_; ++i)
    if (path_[i].fused_with >= 0) frame.codes(path_[i].column).put(at, fused(path_[i]));
  if (++history_at_ == kHistory) history_at_ = 0;
  ++received_;
  return received_ > static_cast<uint32_t>(history_samples_);
}

void Conditioning::move_frame(Frame& frame, int count, int kept) const {
  for (int p = 0; p < path_count_; ++p) {
    Column<Code> column = frame.codes(path_[p].column);
    for (int i = 0; i < kept; ++i) column.put(i, column[i + count]);
  }
}

Code Conditioning::centred(const Channel& channel, int32_t code) {
  return Code::from_raw(between(channel.lowest, code, channel.highest) - channel.offset);
}

// A weighted sum over the window of a path, whose centre is `reach` samples old.
template <int kTaps>
int64_t weighted(const Fixed<int32_t, 0> (&tap)[kTaps], const Code* first, int half_length) {
  int64_t sum = 0;
  for (int k = 0; k <= 2 * half_length; ++k) sum += (tap[k] * first[k]).raw;
  return sum;
}

Code Conditioning::rounded(int64_t sum, int shift) {
  if (shift > 0) sum = (sum + (int64_t{1} << (shift - 1))) >> shift;
  if (sum > kSignalLimit || sum < -kSignalLimit) {
    if (received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;  // not while the filters fill
    sum = sum > 0 ? kSignalLimit : -kSignalLimit;
  }
  return Code::from_raw(static_cast<int32_t>(sum));
}

Code Conditioning::filtered(Path& path, Code code) {
  const SignalConfiguration& signal = configuration_->signals[path.node][path.quantity];
  const Code input = path.sections == 0 ? code : high_passed(path, code);
  path.history[history_at_] = path.history[history_at_ + kHistory] = input;
  if (path.fused_with >= 0) return {};                  // filled once the acceleration's history is
  const Code* window = &path.history[history_at_ + 1];  // window[kHistory - 1] is the newest sample
  const int first = kHistory - 1 - (reach_ - path.early) - signal.half_length;
  const bool for_sign = path.column >= kSignVelocityColumn;  // of which the limit does not matter
  const bool saturated = saturated_;
  const Code value = rounded(weighted(signal.tap, window + first, signal.half_length), signal.shift);
  if (for_sign) saturated_ = saturated;
  return value;
}

// The first slope is taken to have stood there for ever.
Code Conditioning::fused(const Path& path) {
  const SignalConfiguration& signal = configuration_->signals[path.node][path.quantity];
  const FusionConfiguration& fusion = configuration_->fusion[path.node];
  FusionState& state = fusion_[kDerivesSignals ? path.node : 0];
  const int first = history_at_ + 1 + kHistory - 1 - reach_ - signal.half_length;
  const int64_t slope = weighted(signal.tap, &path.history[first], signal.half_length);
  const int64_t step = weighted(fusion.step_tap, &path_[path.fused_with].history[first], signal.half_length);
  if (received_ + 1 < static_cast<uint32_t>(2 * reach_ + 1)) return {};
  if (received_ + 1 == static_cast<uint32_t>(2 * reach_ + 1)) state.slope = slope;
  const int leak = starting_leak(received_ - static_cast<uint32_t>(2 * reach_), fusion.leak_shift);
  const int64_t before = state.once;
  state.once += step - (slope - state.slope) - (state.once >> leak);
  state.twice += state.once - before - (state.twice >> leak);
  state.slope = slope;
  return rounded(slope + state.twice, signal.shift);
}

// First-order sections with the pole 1 - 2^-shift. The differences come first, they take the offset away before the
// integrations sum anything; the very first sample is taken to have stood there for ever, so there is no switch-on
// step.
Code Conditioning::high_passed(Path& path, Code code) const {
  const int differences = path.sections - path.integrations;
  const bool for_sign = path.column >= kSignVelocityColumn;
  const int shift = for_sign ? starting_leak(received_, path.shift) : path.shift;
  State value = rescale<State>(code);
  if (received_ == 0) path.previous[0] = value;
  for (int s = 0; s < path.sections; ++s) {
    State& state = path.section[s];
    if (s < differences) {
      state = state + (value - path.previous[s] - (state >> shift));
      path.previous[s] = value;
      value = state;
    } else {
      state = state + (value - (state >> shift));
      value = state >> (configuration_->high_pass_shift - kIntegrationExtraBits);
    }
  }
  return Code::from_raw(clamp32(rescale<Fixed<int64_t, 0>>(value).raw));
}

}  // namespace firmware
