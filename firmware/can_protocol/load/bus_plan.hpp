// Everything that a rig sends over its bus while it runs, from the frame table, and how much of the bus that takes at worst.
#pragma once
#include "firmware/can_protocol/frame_description.hpp"
#include "firmware/can_protocol/streams/sensor_frames.hpp"

namespace firmware {

// What decides which frames there are and how often.
struct BusTraffic {
  const SensorPlan* sensors = nullptr;  // frames of the sensors; nullptr: the samples do not come over this bus
  int64_t sample_period_ns = 1000000;
  bool drive_on_can = false;     // a drive command for each sample
  bool can_fd = false;           // estimates in CAN FD frames
  bool float_estimates = false;  // once more as floats
  int heartbeat_ms = 100;        // 0: none
  int status_ms = 100;
  int64_t window_ns = 1000000000;  // from one set of estimates to the next
  int unknowns = 0;
  int channels = 0;
};

// So many frames of a kind each period.
struct BusStream {
  const can::FrameDescription* frame = nullptr;
  int frames = 0;
  int64_t period_ns = 0;
};

constexpr int kMaxBusStreams = 20;
struct BusPlan {
  BusStream streams[kMaxBusStreams];
  int count = 0;
};

// Frames on the event (emergency, commands, SDO) are left out: they are rare.
BusPlan bus_plan(const BusTraffic& traffic);

// Bits per second of a bus: at arbitration, and in the data part of CAN FD frames.
struct BitRates {
  int64_t nominal = 500000;
  int64_t data = 2000000;
};

// Part of the bus in per mille that a stream, or all of a plan, takes with the most stuff bits possible; rounded up.
int64_t load_permille(const BusStream& stream, const BitRates& rates);
int64_t load_permille(const BusPlan& plan, const BitRates& rates);

// More than this leaves no room for errors, repetitions and commands, and frames of low priority come late.
constexpr int64_t kHighestLoad_permille = 800;

}  // namespace firmware
