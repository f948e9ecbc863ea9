// The settings of the node in the configuration store. A medium may take seconds: a save runs on a worker where there is
// one, and no step waits for it. What is stored counts only where it was saved for this very rig, programme and limits.
#pragma once
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/interface/configuration_store.hpp"
#include "hal/interface/worker.hpp"

namespace firmware {

class SettingsStore {
 public:
  enum class Outcome : uint8_t { kNone, kSaved, kFailed };

  // worker: nullptr where there is none; begin() then takes as long as the medium.
  SettingsStore(hal::ConfigurationStore& store, hal::Worker* worker) : store_(store), worker_(worker) {}

  bool busy() const { return busy_; }
  void begin(const ControllerConfiguration& configuration);  // not while busy
  Outcome take_outcome();                                    // once after each begin()
  // node: what was stored for this rig, else untouched. False where something is stored and cannot be read.
  bool load(const ControllerConfiguration& own, NodeConfiguration& node);
  bool damaged() const { return damaged_; }  // the last save failed, or what is stored cannot be read

 private:
  static void save(void* self);

  hal::ConfigurationStore& store_;
  hal::Worker* worker_;
  bool busy_ = false;  // bytes_ belong to the store
  bool saved_ = false;
  bool damaged_ = false;
  size_t size_ = 0;
  uint8_t bytes_[kConfigurationBytes] = {};
};

}  // namespace firmware
