#include "firmware/conditioning/conditioning.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

constexpr int32_t kSignalLimit = 1 << 23;
constexpr int kStateFraction = 16;
// Of the high-pass, until what a level started with is forgotten. A double integration turns a start in mid-motion into
// metres: t^2 exp(-t / tau) must fall below 1e-5 of it, which takes 16 time constants.
constexpr int settling_time_constants(int order) { return order > 2 ? 16 : 4; }

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

}  // namespace

void Conditioning::configure(const CoreConfiguration& configuration) {
  configuration_ = &configuration;
  path_count_ = 0;
  reach_ = 0;
  nodes_ = configuration.base_present ? kMaxNodes : configuration.dof_count;
  for (int node = 0; node < kMaxNodes; ++node) {
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const ChannelConfiguration& channel = configuration.channels[node][quantity];
      const int64_t offset = channel.present ? channel.offset_code : 0;
      offset_[node][quantity] = static_cast<int32_t>(offset);
      lowest_[node][quantity] = channel.present ? within(channel.lowest_code, offset) : -kSignalLimit;
      highest_[node][quantity] = channel.present ? within(channel.highest_code, offset) : kSignalLimit;
    }
    if (node >= configuration.dof_count && node != kBaseNode) continue;
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const SignalConfiguration& signal = configuration.signals[node][quantity];
      if (!signal.available) continue;
      Path& path = path_[path_count_++];
      path.node = static_cast<uint8_t>(node);
      path.quantity = static_cast<uint8_t>(quantity);
      path.source = signal.source;
      path.column = static_cast<uint16_t>(signal_column(node, static_cast<Quantity>(quantity)));
      if (signal.half_length > reach_) reach_ = signal.half_length;
    }
  }
  history_samples_ = 2 * reach_;
  if (configuration.high_pass_order > 0)
    history_samples_ += settling_time_constants(configuration.high_pass_order) << configuration.high_pass_shift;
  plain_ = configuration.high_pass_order == 0;
  for (int i = 0; i < path_count_; ++i) {
    const SignalConfiguration& signal = configuration.signals[path_[i].node][path_[i].quantity];
    if (signal.half_length > 0 || signal.tap[0].raw != 0) plain_ = false;
  }
  restart();
}

void Conditioning::restart() {
  received_ = 0;
  saturated_ = false;
  history_at_ = 0;
  for (int i = 0; i < path_count_; ++i)
    for (int s = 0; s < kMaxSections; ++s) path_[i].section[s] = path_[i].previous[s] = 0;
}

bool Conditioning::append(const RawSample& sample, Frame& frame, int at) {
  FIRMWARE_PRECONDITION(configuration_ != nullptr && at >= 0 && at < kFrameSamples);
  int32_t* __restrict column = &frame.column[0][at];
  int32_t beyond[kQuantities] = {};
  for (int node = 0; node < nodes_; ++node, column += kQuantities * kFrameStride) {
    for (int q = 0; q < kQuantities; ++q) {
      const int32_t code = sample.code[node][q];
      beyond[q] |= static_cast<int32_t>(code >= highest_[node][q]) | static_cast<int32_t>(code <= lowest_[node][q]);
    }
    for (int q = 0; q < kQuantities; ++q) column[q * kFrameStride] = centred(node, q, sample.code[node][q]);
  }
  saturated_ = (beyond[0] | beyond[1] | beyond[2] | beyond[3]) != 0;
  return plain_ || filter(sample, frame, at);
}

bool Conditioning::filter(const RawSample& sample, Frame& frame, int at) {
  for (int i = 0; i < path_count_; ++i) {
    Path& path = path_[i];
    const int32_t code = sample.code[path.node][path.source];
    frame.column[path.column][at] = filtered(path, centred(path.node, path.source, code));
  }
  if (++history_at_ == kHistory) history_at_ = 0;
  ++received_;
  return received_ > static_cast<uint32_t>(history_samples_);
}

void Conditioning::move_frame(Frame& frame, int count, int kept) const {
  for (int p = 0; p < path_count_; ++p) {
    int32_t* column = frame.column[path_[p].column];
    for (int i = 0; i < kept; ++i) column[i] = column[i + count];
  }
}

int32_t Conditioning::centred(int node, int quantity, int32_t code) const {
  return between(lowest_[node][quantity], code, highest_[node][quantity]) - offset_[node][quantity];
}

int32_t Conditioning::filtered(Path& path, int32_t code) {
  const SignalConfiguration& signal = configuration_->signals[path.node][path.quantity];
  const int32_t input = configuration_->high_pass_order == 0 ? code : high_passed(path, signal.integrations, code);
  path.history[history_at_] = path.history[history_at_ + kHistory] = input;
  const int32_t* window = &path.history[history_at_ + 1];  // window[kHistory - 1] is the newest sample
  const int first = kHistory - 1 - reach_ - signal.half_length;
  int64_t sum = 0;
  for (int k = 0; k <= 2 * signal.half_length; ++k) sum += static_cast<int64_t>(signal.tap[k].raw) * window[first + k];
  if (signal.shift > 0) sum = (sum + (int64_t{1} << (signal.shift - 1))) >> signal.shift;
  if (sum > kSignalLimit || sum < -kSignalLimit) {
    if (received_ >= static_cast<uint32_t>(history_samples_)) saturated_ = true;  // not while the filters fill
    sum = sum > 0 ? kSignalLimit : -kSignalLimit;
  }
  return static_cast<int32_t>(sum);
}

// First-order sections with the pole 1 - 2^-shift. The differences come first, they take the offset away before the
// integrations sum anything; the very first sample is taken to have stood there for ever, so there is no switch-on
// step.
int32_t Conditioning::high_passed(Path& path, int integrations, int32_t code) const {
  const int shift = configuration_->high_pass_shift;
  const int differences = configuration_->high_pass_order - integrations;
  int64_t value = static_cast<int64_t>(code) * (int64_t{1} << kStateFraction);
  if (received_ == 0) path.previous[0] = value;
  for (int s = 0; s < configuration_->high_pass_order; ++s) {
    int64_t& state = path.section[s];
    if (s < differences) {
      state += value - path.previous[s] - (state >> shift);
      path.previous[s] = value;
      value = state;
    } else {
      state += value - (state >> shift);
      value = state >> (shift - kIntegrationExtraBits);
    }
  }
  return clamp32((value + (int64_t{1} << (kStateFraction - 1))) >> kStateFraction);
}

}  // namespace firmware
