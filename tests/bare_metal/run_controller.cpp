// The whole controller behind hal/interface, with devices that a script moves.
#include <new>

#include "firmware/configuration/bytes.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/bare_metal/sliced_worker.hpp"
#include "tests/bare_metal/script_reader.hpp"
#include "tests/bare_metal/text_line.hpp"

namespace bare_metal {
namespace {

class ScriptClock final : public hal::MonotonicClock {
 public:
  uint64_t now_ns() override { return now; }
  uint64_t now = 1000000;
};

class OneSample final : public hal::SampleSource {
 public:
  hal::SampleResult read(firmware::RawSample& to) override {
    if (!ready) return hal::SampleResult::kNone;
    // As a board's converters do: the codes of the nodes that are there.
    to.sequence = sample.sequence;
    to.time_ns = sample.time_ns;
    for (int node = 0; node < nodes; ++node)
      for (int quantity = 0; quantity < firmware::kQuantities; ++quantity)
        to.code[node][quantity] = sample.code[node][quantity];
    ready = false;
    return hal::SampleResult::kSample;
  }
  firmware::RawSample sample;
  bool ready = false;
  int nodes = firmware::kMaxNodes;
};

class CountingBus final : public hal::CanBus {
 public:
  hal::CanResult send(const firmware::CanFrame& frame) override {
    const uint32_t before = counter->now();
    ++frames;
    for (int i = 0; i < 4; ++i) crc.add(static_cast<uint8_t>(frame.id >> (8 * i)));
    crc.add(frame.length);
    for (int i = 0; i < frame.length; ++i) crc.add(frame.data[i]);
    own_work += counter->now() - before;
    return hal::CanResult::kDone;
  }
  hal::CanResult receive(firmware::CanFrame&) override { return hal::CanResult::kEmpty; }
  uint32_t frames = 0;
  firmware::Crc32 crc;
  WorkCounter* counter = nullptr;
  uint32_t own_work = 0;  // of the check sum, which is no part of the controller
};

class Outputs final : public hal::DriveOutput, public hal::DigitalOutput, public hal::Watchdog {
 public:
  bool write(int32_t) override { return true; }
  bool set(bool) override { return true; }
  void feed() override {}
};

class Released final : public hal::DigitalInput {
 public:
  bool active() override { return false; }
  bool next_edge(hal::LineEdge&) override { return false; }
};

class EmptyStore final : public hal::ConfigurationStore {
 public:
  bool save(const uint8_t*, size_t) override { return false; }
  size_t load(uint8_t*, size_t) override { return 0; }
};

firmware::ControllerConfiguration configuration;
alignas(firmware::RigController) uint8_t controller_memory[sizeof(firmware::RigController)];
ScriptClock clock;
OneSample source;
CountingBus bus;
Outputs outputs;
Released stop_line;
EmptyStore store;

// Slices until the next sample: as many as a processor of 168 MHz has time for at 1 kHz.
constexpr int kSlicesPerStep = 12;
constexpr int kLastSteps = 1000;

void print_frames(Text& out) {
  Line(out).add("frames ").add(int64_t{bus.frames}).add(" crc ").add(int64_t{bus.crc.value()});
}

}  // namespace

bool run_controller(Bytes& script, Text& out, WorkCounter& counter, const Words& words) {
  static ScriptReader reader(script);
  if (!reader.read(configuration)) return false;
  if (words.untested) configuration.core.probe_products_per_sample = 0;
  if (words.open) configuration.core.window.batch_samples = 0;
  configuration.node.listen_on_command = true;
  const auto period_ns =
      static_cast<uint64_t>(to_fixed(configuration.core.sample_period_s * firmware::Scaled::from_int(1000000000), 0));
  alignas(16) static uint8_t stack[kSolveStack];
  static hal::SlicedWorker worker(stack, sizeof stack);
  auto& controller = *new (controller_memory) firmware::RigController(
      configuration, {clock, source, bus, outputs, outputs, outputs, stop_line, nullptr, outputs, store,
                      words.sliced ? &worker : nullptr});
  if (!configuration.core.base_present) source.nodes = configuration.core.dof_count;
  bus.counter = &counter;
  controller.step();
  static Cost steps, solves, slices;
  const auto run_slice = [&] {
    const uint32_t before = counter.now();
    worker.run_slice();
    slices.add(counter.now() - before);
  };
  uint8_t event = 0;
  while (reader.next(event) && event != 'Q') {
    if (event == 'S') {
      if (!reader.read(configuration, source.sample)) return false;
      source.ready = true;
      clock.now += period_ns;
      source.sample.time_ns = clock.now;
      const firmware::Estimates* estimates = controller.estimates();
      const uint32_t windows = estimates != nullptr ? estimates->window_counter : 0;
      const uint32_t before = counter.now() - bus.own_work;
      controller.step();
      const uint32_t work = counter.now() - bus.own_work - before;
      estimates = controller.estimates();
      (estimates != nullptr && estimates->window_counter != windows ? solves : steps).add(work);
      ++source.sample.sequence;
      for (int n = 0; n < kSlicesPerStep && !worker.done(); ++n) run_slice();
    } else if (event == 'L') {
      if (!controller.start()) return false;
    } else if (event == 'E') {
      controller.stop();
      controller.step();
      for (int left = kLastSteps; words.sliced && left > 0; --left) {  // what waits, its estimates, and their frames
        while (!worker.done()) run_slice();
        controller.step();
      }
      print_frames(out);
    } else if (event != 'W') {
      return false;
    }
  }
  print_frames(out);
  steps.print("step", out);
  solves.print("step with a solve", out);
  slices.print("slice", out);
  return event == 'Q';
}

}  // namespace bare_metal
