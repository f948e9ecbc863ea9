// libgpiod 1.x.
#include <errno.h>
#include <gpiod.h>

#include <cstring>

#include "hal/linux/gpio/gpio_line.hpp"
#include "hal/linux/gpio/line_name.hpp"
#include "hal/linux/system/monotonic_clock.hpp"

namespace hal {
namespace {

constexpr const char* kConsumer = "rig_controller";

int flags_of(const LineOptions& options) {
  int flags = options.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
  switch (options.bias) {
    case LineBias::kAsIs:
      break;
    case LineBias::kPullUp:
      return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
    case LineBias::kPullDown:
      return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    case LineBias::kDisabled:
      return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
  }
  return flags;
}

gpiod_line* find_line(const std::string& text) {
  const LineName line = parse_line_name(text);
  if (line.chip.empty()) return gpiod_line_find(line.name.c_str());
  gpiod_chip* chip = gpiod_chip_open_by_name(line.chip.c_str());
  if (chip == nullptr) return nullptr;
  gpiod_line* found = gpiod_chip_get_line(chip, line.offset);
  if (found == nullptr) gpiod_chip_close(chip);
  return found;
}

}  // namespace

struct GpioLine::State {
  gpiod_line* line = nullptr;
  bool events = false;
  ~State() {
    if (line != nullptr) gpiod_line_close_chip(line);  // releases the line too
  }
};

GpioLine::GpioLine() = default;
GpioLine::~GpioLine() = default;

const char* GpioLine::library() { return "libgpiod 1.x"; }

std::string GpioLine::request_input(const std::string& line, const LineOptions& options) {
  auto state = std::make_unique<State>();
  state->line = find_line(line);
  if (state->line == nullptr) return line_not_found(line);
  if (gpiod_line_request_both_edges_events_flags(state->line, kConsumer, flags_of(options)) != 0)
    return "GPIO line \"" + line + "\" cannot be an input with edges: " + std::strerror(errno);
  state->events = true;
  state_ = std::move(state);
  return "";
}

std::string GpioLine::request_output(const std::string& line, const LineOptions& options) {
  auto state = std::make_unique<State>();
  state->line = find_line(line);
  if (state->line == nullptr) return line_not_found(line);
  if (gpiod_line_request_output_flags(state->line, kConsumer, flags_of(options), 0) != 0)
    return "GPIO line \"" + line + "\" cannot be an output: " + std::strerror(errno);
  state_ = std::move(state);
  return "";
}

int GpioLine::get() { return state_ == nullptr ? -1 : gpiod_line_get_value(state_->line); }

bool GpioLine::set(bool active) { return state_ != nullptr && gpiod_line_set_value(state_->line, active ? 1 : 0) == 0; }

int GpioLine::descriptor() const {
  return state_ == nullptr || !state_->events ? -1 : gpiod_line_event_get_fd(state_->line);
}

bool GpioLine::next_edge(LineEdge& edge) {
  if (state_ == nullptr || !state_->events) return false;
  const timespec at_once{};
  if (gpiod_line_event_wait(state_->line, &at_once) != 1) return false;
  gpiod_line_event event{};
  if (gpiod_line_event_read(state_->line, &event) != 0) return false;
  edge.rising = event.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
  edge.time_ns = to_ns(event.ts);
  return true;
}

}  // namespace hal
