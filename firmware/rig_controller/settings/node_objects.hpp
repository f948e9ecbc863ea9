// The object dictionary of the node and the settings behind it. What can be changed over the bus is the heartbeat time;
// "save" keeps it over a restart, "load" goes back to the settings given at start (and keeps those).
#pragma once
#include <cstdint>

#include "firmware/can_protocol/streams/sdo_server.hpp"
#include "firmware/rig_controller/bus/bus_monitor.hpp"
#include "firmware/rig_controller/safety/safe_state.hpp"
#include "firmware/rig_controller/schedule.hpp"
#include "firmware/rig_controller/settings/settings_store.hpp"

namespace firmware {

class NodeObjects final : public ObjectDictionary {
 public:
  // All but the store's worker (nullptr: there is none) are looked at in every step and must outlive this.
  NodeObjects(ControllerConfiguration& configuration, NodeSchedule& schedule, const SafeState& safe,
              const BusMonitor& bus, hal::ConfigurationStore& store, hal::Worker* store_worker);

  // First thing in a step.
  void begin_step(uint64_t now_ns) { now_ns_ = now_ns; }
  Alarm load();  // at start: what was saved for this very rig; kStore where what is stored cannot be read
  void apply();  // the node's settings, from now on
  // Whether take_saved() or take_alarm() may have something.
  bool has_news() const { return settings_.busy() || static_cast<bool>(alarm_); }
  // True once after a save that took longer than the step that began it: answer is for SdoServer::complete().
  bool take_saved(SdoAbort& answer);
  Alarm take_alarm();  // kStore, once after a save that failed

  uint8_t error_register() const;  // object 1001
  uint32_t configuration_crc() const { return configuration_crc_; }
  bool store_damaged() const { return settings_.damaged(); }

  SdoAbort read(uint16_t index, uint8_t subindex, uint8_t (&bytes)[kLongestObject], uint8_t& size) override;
  SdoAbort write(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size) override;

 private:
  SdoAbort store(uint16_t index, uint8_t subindex, uint32_t value, uint8_t size);
  SdoAbort change_heartbeat(uint8_t subindex, uint32_t value, uint8_t size);
  SdoAbort begin_save();
  SdoAbort end_save(SettingsStore::Outcome outcome);

  ControllerConfiguration& configuration_;
  const NodeConfiguration default_node_;  // as given at start
  NodeSchedule& schedule_;
  const SafeState& safe_;
  const BusMonitor& bus_;
  Alarm alarm_;
  uint64_t now_ns_ = 0;
  uint32_t configuration_crc_ = 0;
  SettingsStore settings_;
};

}  // namespace firmware
