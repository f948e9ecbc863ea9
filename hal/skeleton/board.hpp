// Copy this folder to hal/<your board> and fill in the bodies (docs/porting.md). One class per capability. Nothing may
// block, and nothing may be allocated after start.
//
// As it stands the board is safe and useless: the stop reads as pressed, no output delivers, no sample comes. A body that
// is forgotten therefore shows itself as a rig that does not start, never as one that does not stop.
#pragma once
#include <atomic>

#include "hal/interface/can_bus.hpp"
#include "hal/interface/clock.hpp"
#include "hal/interface/configuration_store.hpp"
#include "hal/interface/digital_line.hpp"
#include "hal/interface/drive_output.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/interface/watchdog.hpp"
#include "hal/interface/worker.hpp"

namespace skeleton {

// A free-running timer, widened to 64 bits of nanoseconds. It must not go back and not stop.
class Clock final : public hal::MonotonicClock {
 public:
  uint64_t now_ns() override;
};

// The converters: a timer starts them, an interrupt (or DMA) puts whole samples into a ring, read() takes them out.
// RawSample::sequence counts the timer's ticks, not the samples that arrived: a jump is a missed sample.
//
// One interrupt writes, one reader reads. Each counter is written by one side alone and read by the other with acquire,
// after a release: the sample is there before its number is. (volatile would order nothing.)
class Samples final : public hal::SampleSource {
 public:
  hal::SampleResult read(firmware::RawSample& sample) override;
  uint32_t overflows() const override { return dropped_.load(std::memory_order_relaxed); }
  void sample_complete(const firmware::RawSample& sample);  // called by the interrupt

 private:
  static constexpr unsigned kRing = 64;  // a power of two: the counters may wrap
  firmware::RawSample ring_[kRing] = {};
  std::atomic<unsigned> written_{0};
  std::atomic<unsigned> taken_{0};
  std::atomic<uint32_t> dropped_{0};
};

// The CAN controller. Bus-off and the like are delivered as error frames in SocketCAN's form (linux/can/error.h), which
// firmware/rig_controller/bus/bus_monitor.hpp reads.
class Can final : public hal::CanBus {
 public:
  hal::CanResult send(const hal::CanFrame& frame) override;
  hal::CanResult receive(hal::CanFrame& frame) override;
};

// The converter of the shaker amplifier. In effect before the next sample.
class Drive final : public hal::DriveOutput {
 public:
  bool write(int32_t drive_q31) override;
};

// The stop line: a level, and an edge caught by interrupt so that a short press counts too.
class StopLine final : public hal::DigitalInput {
 public:
  bool active() override;
  bool next_edge(hal::LineEdge& edge) override;
};

// Relay and lamp. Off must be the state without power and after reset.
class Line final : public hal::DigitalOutput {
 public:
  explicit Line(unsigned pin) : pin_(pin) {}
  bool set(bool active) override;

 private:
  unsigned pin_;
};

class Dog final : public hal::Watchdog {
 public:
  void feed() override;
};

// Two pages of flash, written in turn, each with a generation and a check sum (hal/linux/store/file_configuration_store.hpp
// has the same scheme on files). A board without flash keeps this body: settings are then those of the program.
class Store final : public hal::ConfigurationStore {
 public:
  bool save(const uint8_t* bytes, size_t size) override;
  size_t load(uint8_t* bytes, size_t capacity) override;
};

// The long calculations, in the main loop, while step() runs in the timer's interrupt above it. Complete as it stands.
class LoopWorker final : public hal::Worker {
 public:
  void start(void (*work)(void*), void* argument) override;
  bool done() override { return !asked_.load(std::memory_order_acquire); }
  void wait() override;
  void run();  // called by the main loop again and again

 private:
  void (*work_)(void*) = nullptr;
  void* argument_ = nullptr;
  std::atomic<bool> asked_{false};  // set by start(), cleared when the work has ended
};

}  // namespace skeleton
