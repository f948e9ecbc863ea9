#include "firmware/can_protocol/streams/sensor_frames.hpp"

#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {
namespace {

constexpr uint8_t kMotionBit = 1, kForceBit = 2;

bool present(const CoreConfiguration& configuration, int node, Quantity quantity) {
  return configuration.channels[node][static_cast<int>(quantity)].present;
}

CanFrame pack_one(SensorWiring wiring, bool force_frame, int node, const RawSample& sample) {
  const int32_t(&code)[kQuantities] = sample.code[node];
  const int64_t force = code[0], x = code[1], v = code[2], a = code[3];
  const int64_t sequence16 = sample.sequence & 0xFFFF;
  const int member = wire_node(node);
  if (wiring == SensorWiring::kFd) return can::pack<can::kSensorFd>(0, member, {sample.sequence, force, x, v, a});
  if (wiring == SensorWiring::k16) {
    return force_frame ? can::pack<can::kSensorForce>(0, member, {sequence16, force})
                       : can::pack<can::kSensorMotion16>(0, member, {sequence16, x, v, a});
  }
  return force_frame ? can::pack<can::kSensorForce24>(0, member, {sequence16, force, a})
                     : can::pack<can::kSensorMotion24>(0, member, {sequence16, x, v});
}

// Where the codes of a received frame belong. signal 0 is the sequence, the others go to quantity[1], quantity[2], ...
struct SensorFrame {
  const can::FrameDescription* frame;
  SensorWiring wiring;
  uint8_t bit;
  int8_t quantity[5];
};
constexpr SensorFrame kSensorFrames[] = {
    {&can::kSensorMotion16, SensorWiring::k16, kMotionBit, {-1, 1, 2, 3, -1}},
    {&can::kSensorForce, SensorWiring::k16, kForceBit, {-1, 0, -1, -1, -1}},
    {&can::kSensorMotion24, SensorWiring::k24, kMotionBit, {-1, 1, 2, -1, -1}},
    {&can::kSensorForce24, SensorWiring::k24, kForceBit, {-1, 0, 3, -1, -1}},
    {&can::kSensorFd, SensorWiring::kFd, kMotionBit, {-1, 0, 1, 2, 3}},
    {&can::kSensorPair24, SensorWiring::kPairs, kMotionBit, {-1, -1, -1, -1, -1}},
};

// How far a lies after b on the circle of 2^32 sequence numbers.
int32_t ahead(uint32_t a, uint32_t b) { return static_cast<int32_t>(a - b); }

}  // namespace

bool add_to_pairs(SensorPlan& plan, int node, Quantity quantity) {
  if (plan.channel_count == 2 * kMaxNodes) return false;
  const int pair = plan.channel_count / 2;
  plan.wiring[pair] = SensorWiring::kPairs;
  plan.expected[pair] = kMotionBit;
  plan.channels[plan.channel_count++] = {static_cast<uint8_t>(node), static_cast<uint8_t>(quantity)};
  return true;
}

SensorPlan sensor_plan(const CoreConfiguration& configuration, SensorWiring wiring) {
  SensorPlan plan;
  if (wiring == SensorWiring::kPairs) {
    for (int node = 0; node < kMaxNodes; ++node)
      for (int quantity = 0; quantity < kQuantities; ++quantity)
        if (configuration.channels[node][quantity].present &&
            !add_to_pairs(plan, node, static_cast<Quantity>(quantity)))
          return SensorPlan{};
    return plan;
  }
  for (int node = 0; node < kMaxNodes; ++node) {
    const bool force = present(configuration, node, Quantity::kForce);
    const bool slow =
        present(configuration, node, Quantity::kDisplacement) || present(configuration, node, Quantity::kVelocity);
    const bool acceleration = present(configuration, node, Quantity::kAcceleration);
    if (!force && !slow && !acceleration) continue;
    plan.wiring[node] = wiring;
    switch (wiring) {
      case SensorWiring::kNone:
      case SensorWiring::kPairs:
        break;
      case SensorWiring::kFd:
        plan.expected[node] = kMotionBit;
        break;
      case SensorWiring::k16:
        plan.expected[node] = static_cast<uint8_t>((slow || acceleration ? kMotionBit : 0) | (force ? kForceBit : 0));
        break;
      case SensorWiring::k24:
        plan.expected[node] = static_cast<uint8_t>((slow ? kMotionBit : 0) | (force || acceleration ? kForceBit : 0));
        break;
    }
  }
  return plan;
}

int sensor_frames_per_sample(const SensorPlan& plan) {
  int count = 0;
  for (int node = 0; node < kMaxNodes; ++node) count += (plan.expected[node] & 1) + (plan.expected[node] >> 1 & 1);
  return count;
}

// The channel's code; 0 for one that is not there.
static int64_t pair_code(const SensorPlan& plan, const RawSample& sample, int channel) {
  if (channel >= plan.channel_count) return 0;
  return sample.code[plan.channels[channel].node][plan.channels[channel].quantity];
}

int pack_sample(const SensorPlan& plan, const RawSample& sample, CanFrame (&messages)[kMaxSensorFrames]) {
  int count = 0;
  for (int node = 0; node < kMaxNodes; ++node) {
    if (plan.wiring[node] == SensorWiring::kPairs) {
      const int64_t first = pair_code(plan, sample, 2 * node), second = pair_code(plan, sample, 2 * node + 1);
      messages[count++] = can::pack<can::kSensorPair24>(0, node, {sample.sequence & 0xFFFF, first, second});
      continue;
    }
    if (plan.expected[node] & kMotionBit) messages[count++] = pack_one(plan.wiring[node], false, node, sample);
    if (plan.expected[node] & kForceBit) messages[count++] = pack_one(plan.wiring[node], true, node, sample);
  }
  return count;
}

void SensorAssembler::reset() {
  const SensorPlan plan = plan_;
  *this = SensorAssembler(plan);
}

// A 16-bit sequence is taken as the nearest to the newest one.
uint32_t SensorAssembler::unwrap(uint32_t raw, bool whole) {
  if (whole || !started_) return raw;
  return newest_ + static_cast<uint32_t>(static_cast<int16_t>(static_cast<uint16_t>(raw - newest_)));
}

bool SensorAssembler::complete(const OpenSample& open_sample) const {
  for (int node = 0; node < kMaxNodes; ++node)
    if (open_sample.received[node] != plan_.expected[node]) return false;
  return true;
}

void SensorAssembler::give_up(OpenSample& open_sample) {
  ++health_.lost_samples;
  for (int node = 0; node < kMaxNodes; ++node) {
    const int missing = plan_.expected[node] & ~open_sample.received[node];
    if (missing == 0) continue;
    health_.lost_frames += static_cast<uint32_t>((missing & 1) + (missing >> 1 & 1));
    health_.last_lost_node = static_cast<uint8_t>(node);
  }
  if (ahead(open_sample.sample.sequence + 1, next_) > 0) next_ = open_sample.sample.sequence + 1;
  open_sample.used = false;
}

// The open sample of a sequence number; opens one, giving up the oldest where there is no room. Null for a late frame.
SensorAssembler::OpenSample* SensorAssembler::open(uint32_t sequence, uint64_t time_ns) {
  if (ahead(sequence, next_) < 0) {
    ++health_.late_frames;
    return nullptr;
  }
  OpenSample* free_slot = nullptr;
  OpenSample* oldest = nullptr;
  for (OpenSample& candidate : open_) {
    if (!candidate.used) {
      free_slot = &candidate;
    } else if (candidate.sample.sequence == sequence) {
      return &candidate;
    } else if (oldest == nullptr || ahead(candidate.sample.sequence, oldest->sample.sequence) < 0) {
      oldest = &candidate;
    }
  }
  if (free_slot == nullptr) {
    if (ahead(sequence, oldest->sample.sequence) < 0) {
      ++health_.late_frames;
      return nullptr;
    }
    give_up(*oldest);
    free_slot = oldest;
  }
  *free_slot = OpenSample();
  free_slot->used = true;
  free_slot->sample.sequence = sequence;
  free_slot->sample.time_ns = time_ns;
  return free_slot;
}

bool SensorAssembler::push(const CanFrame& message, uint64_t time_ns, RawSample& sample) {
  const SensorFrame* kind = nullptr;
  int rig = 0, member = 0, node = 0;
  for (const SensorFrame& candidate : kSensorFrames) {
    if (!can::is_frame(*candidate.frame, message, rig, member)) continue;
    node = candidate.wiring == SensorWiring::kPairs ? member : node_of_wire(member);
    if (node < 0 || node >= kMaxNodes) break;
    if (plan_.wiring[node] == candidate.wiring && (plan_.expected[node] & candidate.bit)) kind = &candidate;
    break;
  }
  if (kind == nullptr) return false;

  const bool whole = kind->frame->signals[0].length == 32;
  uint32_t sequence = unwrap(static_cast<uint32_t>(can::get_raw(message, kind->frame->signals[0])), whole);
  if (started_ && (ahead(sequence, newest_) > kMaxJump || ahead(sequence, newest_) < -kMaxJump)) {
    for (OpenSample& open_sample : open_)
      if (open_sample.used) give_up(open_sample);
    ++health_.restarts;
    started_ = false;
  }
  if (!started_) next_ = newest_ = sequence;
  started_ = true;
  if (ahead(sequence, newest_) > 0) newest_ = sequence;

  OpenSample* target = open(sequence, time_ns);
  if (target == nullptr) return false;
  if (target->received[node] & kind->bit) {
    ++health_.repeated_frames;
    return false;
  }
  target->received[node] = static_cast<uint8_t>(target->received[node] | kind->bit);
  for (int i = 1; i < kind->frame->signal_count; ++i) {
    SensorPlan::Channel place{static_cast<uint8_t>(node), static_cast<uint8_t>(kind->quantity[i])};
    if (kind->wiring == SensorWiring::kPairs) {
      const int channel = 2 * node + i - 1;
      if (channel >= plan_.channel_count) break;
      place = plan_.channels[channel];
    }
    target->sample.code[place.node][place.quantity] =
        static_cast<int32_t>(can::get_raw(message, kind->frame->signals[i]));
  }
  if (!complete(*target)) return false;

  sample = target->sample;
  target->used = false;
  for (OpenSample& older : open_)
    if (older.used && ahead(older.sample.sequence, sequence) < 0) give_up(older);
  next_ = sequence + 1;
  ++health_.samples;
  return true;
}

}  // namespace firmware
