#include <initializer_list>
#include <new>

#include "firmware/estimator_core.hpp"
#include "hal/bare_metal/sliced_worker.hpp"
#include "tests/bare_metal/script_reader.hpp"
#include "tests/bare_metal/text_line.hpp"

namespace bare_metal {
namespace {

// All static: the core is larger than a stack.
firmware::ControllerConfiguration configuration;
alignas(firmware::EstimatorCore) uint8_t core_memory[sizeof(firmware::EstimatorCore)];

void print_estimates(const firmware::Estimates& estimates, Text& out) {
  Line(out).add("estimates ").add(int64_t{estimates.unknown_count}).add(" rows ").add(int64_t{estimates.rows});
  for (int i = 0; i < estimates.unknown_count; ++i) {
    const firmware::ParameterEstimate& p = estimates.parameters[i];
    Line line(out);
    for (const firmware::Scaled& value : {p.value, p.std, p.ci95_low, p.ci95_high}) line.add(value).add(" ");
    line.add(static_cast<int64_t>(p.status));
  }
}

}  // namespace

Words read_words(const char* text) {
  Words words;
  const auto named = [&](const char* name) {
    int n = 0;
    while (name[n] != 0 && name[n] == text[n]) ++n;
    return name[n] == 0 && (text[n] == 0 || text[n] == ' ');
  };
  for (; *text != 0; ++text) {
    words.plain = words.plain || named("plain");
    words.untested = words.untested || named("untested");
    words.frames = words.frames || named("frames");
    words.open = words.open || named("open");
    words.sliced = words.sliced || named("sliced");
  }
  return words;
}

bool run_core(Bytes& script, Text& out, WorkCounter& counter, const Words& words) {
  static ScriptReader reader(script);
  if (!reader.read(configuration)) return false;
  if (words.untested) configuration.core.probe_products_per_sample = 0;
  if (words.open) configuration.core.window.batch_samples = 0;
  firmware::EstimatorCore& core = *new (core_memory) firmware::EstimatorCore(
      configuration.core, words.plain ? firmware::CoreDetail::kPlain : firmware::CoreDetail::kFull);
  if (!core.fits()) return false;
  firmware::RawSample sample;
  static Cost push, solve, slice;
  alignas(16) static uint8_t stack[kSolveStack];
  static hal::SlicedWorker worker(stack, sizeof stack);
  uint8_t event = 0;
  while (reader.next(event) && event != 'Q') {
    if (event == 'S') {
      if (!reader.read(configuration, sample)) return false;
      const uint32_t before = counter.now();
      core.push(sample);
      push.add(counter.now() - before);
      ++sample.sequence;
    } else if (event == 'W') {
      const uint32_t before = counter.now();
      if (words.sliced) {
        worker.start([](void* solved) { static_cast<firmware::EstimatorCore*>(solved)->solve(); }, &core);
        while (!worker.done()) {
          const uint32_t begun = counter.now();
          worker.run_slice();
          slice.add(counter.now() - begun);
        }
      } else {
        core.solve();
      }
      solve.add(counter.now() - before);
      print_estimates(core.estimates(), out);
    } else if (event == 'L') {
      core.begin_level();
    } else if (event == 'E') {
      core.end_level();
    } else {
      return false;
    }
  }
  push.print("push", out);
  if (push.total > 0) Line(out).add("median ").add(int64_t{push.median()});
  solve.print("solve", out);
  slice.print("slice", out);
  return event == 'Q';
}

}  // namespace bare_metal
