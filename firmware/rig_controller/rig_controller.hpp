// The rig controller: the same class on a board, in host_sim and in the tests. It sees the world through hal/interface
// only.
//
// step() takes whatever is ready and returns; it never waits. Call it once per sample or more often. Its order is what
// makes an emergency stop act before the next sample: emergency-stop line first, then received frames, samples, window,
// schedule, transmit queue, watchdog.
//
// With levels in the programme the controller drives: start() closes the relay and runs them. With none it listens: the
// drive stays at zero, the relay open, and everything from the first sample to the end of the source is one level; or,
// with listen_on_command, whatever lies between a start and a stop is a level, and reset() between levels forgets them
// all.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/streams/sdo_server.hpp"
#include "firmware/excitation/excitation.hpp"
#include "firmware/rig_controller/bus/bus_monitor.hpp"
#include "firmware/rig_controller/bus/description_frames.hpp"
#include "firmware/rig_controller/bus/transmit_queue.hpp"
#include "firmware/rig_controller/bus/window_frames.hpp"
#include "firmware/rig_controller/levels/measurement.hpp"
#include "firmware/rig_controller/safety/alarm_message.hpp"
#include "firmware/rig_controller/safety/ready_lamp.hpp"
#include "firmware/rig_controller/safety/safe_state.hpp"
#include "firmware/rig_controller/schedule.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "firmware/rig_controller/settings/node_objects.hpp"
#include "firmware/supervision/supervisor.hpp"
#include "hal/interface/can_bus.hpp"
#include "hal/interface/clock.hpp"
#include "hal/interface/configuration_store.hpp"
#include "hal/interface/digital_line.hpp"
#include "hal/interface/drive_output.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/interface/watchdog.hpp"

namespace firmware {

// The board around the controller; all of it must outlive the controller.
struct Ports {
  hal::MonotonicClock& clock;
  hal::SampleSource& samples;
  hal::CanBus& can;
  hal::DriveOutput& drive;
  hal::DigitalOutput& relay;          // shaker enable: off whenever the drive must be dead
  hal::DigitalOutput& ready_lamp;     // on while nothing is latched
  hal::DigitalInput& emergency_stop;  // active: stop
  hal::DigitalInput* sync_edge;       // rising edge closes the window; nullptr: none
  hal::Watchdog& watchdog;
  hal::ConfigurationStore& store;
  hal::Worker* worker = nullptr;  // the estimates are worked out there; nullptr: within step(), which then takes long
  hal::Worker* store_worker = nullptr;  // a save runs there, as long as it takes; nullptr: within step()
};

class RigController final {
 public:
  RigController(const ControllerConfiguration& configuration, const Ports& ports);

  void step();

  // Each works from the first step() on, and is also a CANopen network command on the bus (identifier 0: command, node
  // or 0 for all).
  bool start();  // command 1: from the first level, estimates forgotten. False: a fault is latched, it runs already, or
                 // the table of levels is full
  void stop();   // command 2: ramps down; when listening, closes the level
  bool reset();  // command 129: forgets the latched fault. False: its cause is still there

  // Before the first step(): the programme does not start by itself, whatever the configuration says.
  void wait_for_start() { starts_by_itself_ = false; }

  ControllerMode mode() const;
  // The programme is done, or the source has ended, and all estimates are out.
  bool finished() const { return finished_ && measurement_.idle(); }
  const Alarm& latched_alarm() const { return safe_.latched(); }
  const SafeState& safe_state() const { return safe_; }
  const Diagnosis& diagnosis() const { return windows_.diagnosis(); }  // of the last judgement
  const Estimates* estimates() const { return windows_.estimates(); }  // of the last window; nullptr before the first
  const Excitation& excitation() const { return excitation_; }
  const EstimatorCore& core() const { return measurement_.estimation().core(); }
  const BusMonitor& bus() const { return bus_; }
  const TransmitQueue& transmit_queue() const { return queue_; }
  const SupervisionCounters& counters() const { return supervisor_.counters(); }
  uint32_t trips() const { return safe_.trips(); }
  const NodeConfiguration& node() const { return configuration_.node; }

 private:
  static constexpr int kSamplesPerStep =
      64;  // a burst of buffered samples is taken in parts: the stop line is looked at between
  static constexpr int kFramesPerStep = 64;
  static constexpr int kEdgesPerStep = 16;
  static constexpr uint64_t kSourceGone_ns = 1000000000;  // of failed reads alone: as long as the longest window

  // rig_controller.cpp: the course of a step
  void boot();
  void go_on_measuring();
  bool start_listening();
  void forget_estimates();
  bool take_samples();
  void take_sample(const RawSample& sample);
  bool begins_level() const;
  void drive_on(const RawSample& sample);
  void source_stopped(bool fault);
  void follow(ExcitationEvent event);
  void end_level();
  void response_codes(const RawSample& sample, int32_t (&codes)[kMaxDofs]) const;
  void command_drive(Drive wanted, uint32_t sequence);
  // Most of the time there is none.
  void handle(const Alarm& alarm) {
    if (alarm) tell(alarm);
  }
  void judge(const Alarm& alarm) {
    if (alarm) stop_or_tell(alarm);
  }
  void tell(const Alarm& alarm);
  void stop_or_tell(const Alarm& alarm);

  // rig_controller_frames.cpp: what comes and goes over the bus
  void receive_frames(hal::CanResult result);
  void receive(const hal::CanFrame& frame);
  void follow(const NetworkCommand& command);
  void follow(BusEvent event);
  void check_sync_edge();
  void check_save();
  void take_results();
  void run_schedule();
  void send_waiting();
  void send_heartbeat();
  void send_status();
  void send_health();
  void tell_overflows();
  void send_alarms();
  void flush_queue();
  uint16_t fault_bits() const;

  // What every step looks at stands in front, the large things behind.
  Ports ports_;
  uint64_t now_ns_ = 0;
  uint64_t boot_ns_ = 0;
  uint64_t stopped_ns_ = 0;  // the source, where it has
  bool booted_ = false;
  const bool listening_;  // no programme: measure whatever comes
  bool finished_ = false;
  bool source_stopped_ = false, source_gone_ = false;  // it failed or ended, and no sample has come since; for good
  bool starts_by_itself_ = true;                       // where the configuration says so
  bool start_waits_ = false;     // start_at_boot, until the outputs are safe and the samples fresh
  uint16_t passing_faults_ = 0;  // seen since the last status frame
  uint32_t reported_drops_ = 0;
  uint32_t reported_overflows_ = 0;
  RawSample sample_;     // the last one; channels that are not there stay 0
  hal::CanFrame frame_;  // the last one received
  DriveLink drive_;
  SafeState safe_;
  ReadyLamp lamp_;
  BusMonitor bus_;
  NodeSchedule schedule_;
  WindowFrames windows_;
  DescriptionFrames descriptions_;
  AlarmQueue alarms_;
  Supervisor supervisor_;
  ControllerConfiguration configuration_;
  Excitation excitation_;
  NodeObjects objects_;
  SdoServer sdo_;
  TransmitQueue queue_;
  Measurement measurement_;
};

}  // namespace firmware
