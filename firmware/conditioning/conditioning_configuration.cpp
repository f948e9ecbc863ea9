// Which paths signals take, and what those of one channel share: once for a rig.
#include "firmware/conditioning/conditioning.hpp"
#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

// Of the high-pass, until what a level started with is forgotten. A double integration turns a start in mid-motion into
// metres: t^2 exp(-t / tau) must fall below 1e-5 of it, which takes 16 time constants. What is integrated once has no such start
// (Conditioning::high_passed()).
constexpr int settling_time_constants(int order) { return order > 2 ? 16 : 1; }

// log2 of how much lower the corner of the velocity is whose sign friction has.
constexpr int kLowerSignCorner = 3;
// Of the fusion's corner, until the noise of the slope that it started with is forgotten; the corner comes down step by step
// (starting_leak), four time constants each.
constexpr int kFusionTimeConstants = 2;

// A rail as the signal's 24 bits about the offset allow it.
int32_t within(int32_t rail, int64_t offset) {
  const int64_t lowest = offset - kSignalLimit, highest = offset + kSignalLimit;
  const int64_t nearest = rail < lowest ? lowest : rail > highest ? highest : rail;
  return static_cast<int32_t>(nearest > INT32_MAX ? INT32_MAX : nearest < -INT32_MAX ? -INT32_MAX : nearest);
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
  alike_count_ = channel_count_ + channel_count_ % 2;
  if (channel_count_ % 2 == 1) place_[channel_count_] = place_[channel_count_ - 1];
  for (int c = 1; c < channel_count_; ++c)
    if (channel_[c].inside != channel_->inside || channel_[c].count != channel_->count ||
        channel_[c].offset != channel_->offset)
      alike_count_ = 0;
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
  shift_nothing();
  restart();
}

void Conditioning::shift_nothing() {
  shift_.clear();
  shifts_ = false;
  copies_alone_ = !kDerivesSignals || plain_;
}

void Conditioning::add_channel(int node, int quantity) {
  const ChannelConfiguration& configured = configuration_->channels[node][quantity];
  const auto code = static_cast<uint32_t>(node * kQuantities + quantity);
  place_[channel_count_] = {code, code * kFrameStride};
  Channel& channel = channel_[channel_count_++];
  channel.offset = configured.offset_code;
  channel.inside = within(configured.lowest_code, configured.offset_code) + 1;
  const int64_t count = int64_t{within(configured.highest_code, configured.offset_code)} - channel.inside;
  channel.count = count > 0 ? static_cast<uint32_t>(count) : 0;
}

void Conditioning::shift(int number, int node, Quantity quantity, const ShiftTaps& taps) {
  const auto code = static_cast<uint32_t>(node * kQuantities + static_cast<int>(quantity));
  for (int c = 0; c < channel_count_; ++c)
    if (place_[c].code == code) shift_.set(number, c, taps);
  shifts_ = shift_.used();
  copies_alone_ = !shifts_ && copies_alone_;
}

Conditioning::Path& Conditioning::add_path(int node, int quantity, int column) {
  const SignalConfiguration& signal = configuration_->signals[node][quantity];
  Path& path = path_[path_count_++];
  path.signal = static_cast<uint8_t>(node * kQuantities + quantity);
  path.channel_column = static_cast<uint16_t>(place_[0].column);
  for (int c = 0; c < channel_count_; ++c)
    if (place_[c].code == static_cast<uint32_t>(node * kQuantities + signal.source))
      path.channel_column = static_cast<uint16_t>(place_[c].column);
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
  waiting_ = kWaiting * configuration_->sign_half_length;
  limit_bit_ = uint32_t{1} << configuration_->sign_half_length;
  for (int i = 0; i + kWaiting < path_count_; ++i) share_early_three(i);
  for (int i = 0; i < path_count_; ++i) delay_velocity(i);
  list_turns();
}

void Conditioning::list_turns() {
  keep_count_ = work_count_ = 0;
  for (int i = 0; i < path_count_; ++i)
    if (path_[i].turn & kThree) works_[work_count_++] = static_cast<uint8_t>(i);
  three_count_ = work_count_;
  for (int i = 0; i < path_count_; ++i) {
    if (path_[i].turn & kKeepsHistory) keeps_[keep_count_++] = static_cast<uint8_t>(i);
    if (path_[i].turn & (kAlone | kFused | kDelayed)) works_[work_count_++] = static_cast<uint8_t>(i);
  }
}

// Displacement, velocity and acceleration of one channel where the velocity comes early for friction's sign: all three are made
// then, and wait.
void Conditioning::share_early_three(int number) {
  Path *const x = path_ + number, *const end = x + kWaiting, *sign = nullptr;
  for (Path* path = end; path != path_ + path_count_; ++path)
    if (early(*path) > 0 && path->history_of == number) sign = path;
  if (sign == nullptr || !is(Quantity::kDisplacement, *x)) return;
  for (const Path* path = x; path != end; ++path) {
    const bool same = path->history_of == number && path->turn & kAlone;
    if (!same || path->column != x->column + (path - x) * kFrameStride || path->parity != (path == x + 1 ? -1 : 1))
      return;
  }
  for (Path* path = x; path != end; ++path) path->turn = 0;
  sign->turn = 0;
  x->turn = kThree;
  x->window = sign->window;
  x[1].window = sign->column;
}

// Where no high-pass stands before them, a velocity and the one that its sign is taken from differ in their time alone.
void Conditioning::delay_velocity(int number) {
  Path& path = path_[number];
  if (!is(Quantity::kVelocity, path) || early(path) > 0 || !(path.turn & kAlone)) return;
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

}  // namespace firmware
