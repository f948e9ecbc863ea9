// libgpiod 2.x.
#include <dirent.h>
#include <errno.h>
#include <gpiod.h>

#include <cstring>

#include "hal/linux/gpio/gpio_line.hpp"
#include "hal/linux/gpio/line_name.hpp"

namespace hal {
namespace {

constexpr const char* kConsumer = "rig_controller";
constexpr size_t kEvents = 16;

template <typename T, void (*free)(T*)>
struct Free {
  void operator()(T* object) const { free(object); }
};
using Chip = std::unique_ptr<gpiod_chip, Free<gpiod_chip, gpiod_chip_close>>;
using Settings = std::unique_ptr<gpiod_line_settings, Free<gpiod_line_settings, gpiod_line_settings_free>>;
using LineConfig = std::unique_ptr<gpiod_line_config, Free<gpiod_line_config, gpiod_line_config_free>>;
using RequestConfig = std::unique_ptr<gpiod_request_config, Free<gpiod_request_config, gpiod_request_config_free>>;
using Request = std::unique_ptr<gpiod_line_request, Free<gpiod_line_request, gpiod_line_request_release>>;
using Events = std::unique_ptr<gpiod_edge_event_buffer, Free<gpiod_edge_event_buffer, gpiod_edge_event_buffer_free>>;

gpiod_line_bias bias_of(LineBias bias) {
  switch (bias) {
    case LineBias::kAsIs:
      return GPIOD_LINE_BIAS_AS_IS;
    case LineBias::kPullUp:
      return GPIOD_LINE_BIAS_PULL_UP;
    case LineBias::kPullDown:
      return GPIOD_LINE_BIAS_PULL_DOWN;
    case LineBias::kDisabled:
      return GPIOD_LINE_BIAS_DISABLED;
  }
  return GPIOD_LINE_BIAS_AS_IS;
}

// The chip that has a line of this name; offset is set.
Chip find_by_name(const std::string& name, unsigned& offset) {
  DIR* folder = opendir("/dev");
  Chip found;
  while (const dirent* entry = folder == nullptr || found ? nullptr : readdir(folder)) {
    const std::string path = std::string("/dev/") + entry->d_name;
    if (std::strncmp(entry->d_name, "gpiochip", 8) != 0 || !gpiod_is_gpiochip_device(path.c_str())) continue;
    Chip chip(gpiod_chip_open(path.c_str()));
    const int at = chip ? gpiod_chip_get_line_offset_from_name(chip.get(), name.c_str()) : -1;
    if (at < 0) continue;
    offset = static_cast<unsigned>(at);
    found = std::move(chip);
  }
  if (folder != nullptr) closedir(folder);
  return found;
}

Chip find_chip(const std::string& text, unsigned& offset) {
  const LineName line = parse_line_name(text);
  if (line.chip.empty()) return find_by_name(line.name, offset);
  offset = line.offset;
  return Chip(gpiod_chip_open(("/dev/" + line.chip).c_str()));
}

Request request(gpiod_chip* chip, unsigned offset, gpiod_line_settings* settings) {
  const LineConfig lines(gpiod_line_config_new());
  const RequestConfig about(gpiod_request_config_new());
  if (!lines || !about || gpiod_line_config_add_line_settings(lines.get(), &offset, 1, settings) != 0) return nullptr;
  gpiod_request_config_set_consumer(about.get(), kConsumer);
  return Request(gpiod_chip_request_lines(chip, about.get(), lines.get()));
}

}  // namespace

struct GpioLine::State {
  unsigned offset = 0;
  Request request;
  Events events;  // inputs only
};

GpioLine::GpioLine() = default;
GpioLine::~GpioLine() = default;

const char* GpioLine::library() { return "libgpiod 2.x"; }

std::string GpioLine::request_input(const std::string& line, const LineOptions& options) {
  auto state = std::make_unique<State>();
  const Chip chip = find_chip(line, state->offset);
  if (!chip) return line_not_found(line);
  const Settings settings(gpiod_line_settings_new());
  state->events.reset(gpiod_edge_event_buffer_new(kEvents));
  if (!settings || !state->events) return "GPIO line \"" + line + "\": out of memory";
  gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT);
  gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_BOTH);
  gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC);
  gpiod_line_settings_set_active_low(settings.get(), options.active_low);
  gpiod_line_settings_set_bias(settings.get(), bias_of(options.bias));
  state->request = request(chip.get(), state->offset, settings.get());
  if (!state->request) return "GPIO line \"" + line + "\" cannot be an input with edges: " + std::strerror(errno);
  state_ = std::move(state);
  return "";
}

std::string GpioLine::request_output(const std::string& line, const LineOptions& options) {
  auto state = std::make_unique<State>();
  const Chip chip = find_chip(line, state->offset);
  if (!chip) return line_not_found(line);
  const Settings settings(gpiod_line_settings_new());
  if (!settings) return "GPIO line \"" + line + "\": out of memory";
  gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT);
  gpiod_line_settings_set_output_value(settings.get(), GPIOD_LINE_VALUE_INACTIVE);
  gpiod_line_settings_set_active_low(settings.get(), options.active_low);
  gpiod_line_settings_set_bias(settings.get(), bias_of(options.bias));
  state->request = request(chip.get(), state->offset, settings.get());
  if (!state->request) return "GPIO line \"" + line + "\" cannot be an output: " + std::strerror(errno);
  state_ = std::move(state);
  return "";
}

int GpioLine::get() {
  if (state_ == nullptr) return -1;
  switch (gpiod_line_request_get_value(state_->request.get(), state_->offset)) {
    case GPIOD_LINE_VALUE_INACTIVE:
      return 0;
    case GPIOD_LINE_VALUE_ACTIVE:
      return 1;
    default:
      return -1;
  }
}

bool GpioLine::set(bool active) {
  return state_ != nullptr &&
         gpiod_line_request_set_value(state_->request.get(), state_->offset,
                                      active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE) == 0;
}

int GpioLine::descriptor() const {
  return state_ == nullptr || !state_->events ? -1 : gpiod_line_request_get_fd(state_->request.get());
}

bool GpioLine::next_edge(LineEdge& edge) {
  if (state_ == nullptr || !state_->events) return false;
  if (gpiod_line_request_wait_edge_events(state_->request.get(), 0) != 1) return false;
  if (gpiod_line_request_read_edge_events(state_->request.get(), state_->events.get(), 1) != 1) return false;
  gpiod_edge_event* event = gpiod_edge_event_buffer_get_event(state_->events.get(), 0);
  edge.rising = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE;
  edge.time_ns = gpiod_edge_event_get_timestamp_ns(event);
  return true;
}

}  // namespace hal
