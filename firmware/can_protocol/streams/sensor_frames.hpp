// Samples as sensor frames, and sensor frames joined to samples again.
//
// Three wirings of a DOF (or of the base), chosen by the resolution of its sensors and by the bus:
//   k16  sensor_motion_16 (x, v, a: 16 bits each), and sensor_force (24 bits) where the DOF is driven
//   k24  sensor_motion_24 (x, v) and sensor_force_24 (force, a); each is sent only where it carries a channel
//   kFd  sensor_fd: all four with 24 bits, CAN FD
// and one of the whole rig:
//   kPairs  sensor_pair_24: its channels two by two, 24 bits each, in the order of DOF (the base last) and quantity; no
//           place stays empty, so 3 DOFs with 3 channels take 5 frames where k24 takes 6
// All frames of one sample carry its number; the classic ones 16 bits of it, which the receiver counts on to 32.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/can_protocol/can_frame.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

enum class SensorWiring : uint8_t { kNone = 0, k16, k24, kFd, kPairs };

// Which frames make a sample complete. Bit 0 of expected[node]: the motion frame (or the FD frame), bit 1: the force
// frame.
struct SensorPlan {
  SensorWiring wiring[kMaxNodes] = {};
  uint8_t expected[kMaxNodes] = {};
  // kPairs: pair number i, at wiring[i] and expected[i] like a node, carries the channels 2 i and 2 i + 1.
  struct Channel {
    uint8_t node = 0, quantity = 0;
  };
  Channel channels[2 * kMaxNodes];
  int channel_count = 0;
};
SensorPlan sensor_plan(const CoreConfiguration& configuration,
                       SensorWiring wiring);  // one wiring for all channels present
// Adds the next channel of kPairs; false where there is no room for it.
bool add_to_pairs(SensorPlan& plan, int node, Quantity quantity);
int sensor_frames_per_sample(const SensorPlan& plan);

constexpr int kMaxSensorFrames = 2 * kMaxNodes;
// Writes the frames of a sample and returns their number. Codes beyond the width of their signal are clamped.
int pack_sample(const SensorPlan& plan, const RawSample& sample, CanFrame (&messages)[kMaxSensorFrames]);

// Counters since start, each named by its cause.
struct AssemblyHealth {
  uint32_t samples = 0;                  // complete
  uint32_t lost_samples = 0;             // given up because a frame of theirs never came
  uint32_t lost_frames = 0;              // that never came, of samples of which at least one frame came
  uint32_t late_frames = 0;              // of a sample already given up or handed on
  uint32_t repeated_frames = 0;          // seen twice in one sample
  uint32_t restarts = 0;                 // the sequence jumped by more than kMaxJump samples: counting starts anew
  uint8_t last_lost_node = kGroundNode;  // node index whose frame was missing last
};

// Joins the frames of one sequence number. Sensors may be late by up to kOpenSamples - 1 samples against each other;
// samples come out in order, and one that is still incomplete when a newer one is complete (or has to make room) is
// given up: the jump in RawSample::sequence tells the core.
class SensorAssembler {
 public:
  static constexpr int kOpenSamples = 4;
  static constexpr int kMaxJump = 1024;

  explicit SensorAssembler(const SensorPlan& plan) : plan_(plan) {}
  void reset();
  // True where this frame completes a sample, which is then in `sample` with the reception time of its first frame.
  // Frames that are no sensor frames of the plan are passed over.
  bool push(const CanFrame& message, uint64_t time_ns, RawSample& sample);
  const AssemblyHealth& health() const { return health_; }

 private:
  struct OpenSample {
    bool used = false;
    RawSample sample;
    uint8_t received[kMaxNodes] = {};
  };
  OpenSample* open(uint32_t sequence, uint64_t time_ns);
  void give_up(OpenSample& open_sample);
  bool complete(const OpenSample& open_sample) const;
  uint32_t unwrap(uint32_t raw, bool whole);

  SensorPlan plan_;
  OpenSample open_[kOpenSamples];
  AssemblyHealth health_;
  bool started_ = false;
  uint32_t newest_ = 0;  // largest sequence seen
  uint32_t next_ = 0;    // smallest sequence that is still welcome
};

}  // namespace firmware
