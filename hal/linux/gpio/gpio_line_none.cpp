// No libgpiod when this was built: every request for a line says so.
#include "hal/linux/gpio/gpio_line.hpp"

namespace hal {
namespace {

std::string missing(const std::string& line) {
  return "GPIO line \"" + line +
         "\": this program was built without libgpiod (libgpiod-dev, or RIG_SYSROOT for a cross build)";
}

}  // namespace

struct GpioLine::State {};

GpioLine::GpioLine() = default;
GpioLine::~GpioLine() = default;
const char* GpioLine::library() { return "no libgpiod"; }
std::string GpioLine::request_input(const std::string& line, const LineOptions&) { return missing(line); }
std::string GpioLine::request_output(const std::string& line, const LineOptions&) { return missing(line); }
int GpioLine::get() { return -1; }
bool GpioLine::set(bool) { return false; }
int GpioLine::descriptor() const { return -1; }
bool GpioLine::next_edge(LineEdge&) { return false; }

}  // namespace hal
