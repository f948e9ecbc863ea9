// See settings_store.hpp.
#include "firmware/rig_controller/settings/settings_store.hpp"

namespace firmware {

void SettingsStore::begin(const ControllerConfiguration& configuration) {
  size_ = encode(configuration, bytes_);
  busy_ = true;
  if (worker_ != nullptr) return worker_->start(&SettingsStore::save, this);
  save(this);
}

void SettingsStore::save(void* self) {
  auto& own = *static_cast<SettingsStore*>(self);
  own.saved_ = own.store_.save(own.bytes_, own.size_);
}

SettingsStore::Outcome SettingsStore::take_outcome() {
  if (!busy_ || (worker_ != nullptr && !worker_->done())) return Outcome::kNone;
  busy_ = false;
  damaged_ = !saved_;
  return saved_ ? Outcome::kSaved : Outcome::kFailed;
}

bool SettingsStore::load(const ControllerConfiguration& own, NodeConfiguration& node) {
  const size_t size = store_.load(bytes_, kConfigurationBytes);
  damaged_ = size != 0 && read_stored(bytes_, size, own, node) == Stored::kDamaged;
  return !damaged_;
}

}  // namespace firmware
