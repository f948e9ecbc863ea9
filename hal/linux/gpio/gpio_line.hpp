// Digital lines by libgpiod. The library's two generations have nothing in common but the name; each has one small file
// (gpio_line_v1.cpp for 1.6, gpio_line_v2.cpp for 2.x) behind class GpioLine, chosen when compiling. gpio_line_none.cpp
// stands in where there is no libgpiod.
#pragma once
#include <memory>
#include <string>

#include "hal/interface/digital_line.hpp"

namespace hal {

enum class LineBias { kAsIs, kPullUp, kPullDown, kDisabled };

struct LineOptions {
  bool active_low = false;
  LineBias bias = LineBias::kAsIs;
};

// A requested line. Nothing is allocated after the request.
class GpioLine {
 public:
  GpioLine();
  ~GpioLine();
  GpioLine(const GpioLine&) = delete;
  GpioLine& operator=(const GpioLine&) = delete;

  // line: its name in the device tree ("emergency_stop"), or chip and offset ("gpiochip0:8"). Empty where it worked,
  // else what is wrong and what was expected.
  std::string request_input(const std::string& line, const LineOptions& options);   // with both edges
  std::string request_output(const std::string& line, const LineOptions& options);  // inactive

  int get();  // logical level: 0, 1, or -1: the kernel refused
  bool set(bool active);
  int descriptor() const;  // readable when an edge waits; -1: not requested
  // Takes one waiting edge; the kernel's time stamp, monotonic clock. False: none.
  bool next_edge(LineEdge& edge);

  static const char* library();  // "libgpiod 1.x"

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class GpioInput final : public DigitalInput {
 public:
  std::string open(const std::string& line, const LineOptions& options) { return line_.request_input(line, options); }
  // A line that cannot be read counts as active: for a stop line that is the safe side.
  bool active() override { return line_.get() != 0; }
  bool next_edge(LineEdge& edge) override {
    if (!line_.next_edge(edge)) return false;
    if (edge.rising) last_rise_ns_ = edge.time_ns;
    return true;
  }
  uint64_t last_rise_ns() const { return last_rise_ns_; }  // of the edges taken; 0: none yet
  int descriptor() const { return line_.descriptor(); }

 private:
  GpioLine line_;
  uint64_t last_rise_ns_ = 0;
};

class GpioOutput final : public DigitalOutput {
 public:
  std::string open(const std::string& line, const LineOptions& options) { return line_.request_output(line, options); }
  bool set(bool active) override { return line_.set(active); }

 private:
  GpioLine line_;
};

// Where the board has no such line.
class NoInput final : public DigitalInput {
 public:
  bool active() override { return false; }
  bool next_edge(LineEdge&) override { return false; }
};
class NoOutput final : public DigitalOutput {
 public:
  bool set(bool) override { return true; }
};

}  // namespace hal
