#include "tests/bare_metal/script.hpp"

#include <new>

#include "firmware/estimator_core.hpp"
#include "firmware/rig_controller/controller_configuration.hpp"

namespace bare_metal {
namespace {

class Reader {
 public:
  explicit Reader(Bytes& bytes) : bytes_(bytes) {}
  bool take(uint8_t& byte) {
    if (at_ == size_) {
      at_ = 0;
      size_ = bytes_.read(buffer_, sizeof buffer_);
      if (size_ == 0) return false;
    }
    byte = buffer_[at_++];
    return true;
  }
  bool take(uint32_t& value) {
    uint8_t byte[4];
    for (uint8_t& b : byte)
      if (!take(b)) return false;
    value = byte[0] | static_cast<uint32_t>(byte[1]) << 8 | static_cast<uint32_t>(byte[2]) << 16 |
            static_cast<uint32_t>(byte[3]) << 24;
    return true;
  }

 private:
  Bytes& bytes_;
  uint8_t buffer_[4096];
  size_t size_ = 0, at_ = 0;
};

class Line {
 public:
  explicit Line(Text& out) : out_(out) {}
  ~Line() {
    add("\n");
    out_.print(text_, size_);
  }
  Line& add(const char* text) {
    while (*text != 0 && size_ < sizeof text_) text_[size_++] = *text++;
    return *this;
  }
  Line& add(int64_t value) {
    char digits[24];
    int n = 0;
    uint64_t rest = value < 0 ? ~static_cast<uint64_t>(value) + 1 : static_cast<uint64_t>(value);
    do {
      digits[n++] = static_cast<char>('0' + static_cast<int>(rest % 10));
      rest /= 10;
    } while (rest > 0);
    if (value < 0) digits[n++] = '-';
    while (n > 0 && size_ < sizeof text_) text_[size_++] = digits[--n];
    return *this;
  }
  Line& add(firmware::Scaled value) { return add(value.mantissa).add(":").add(int64_t{value.exponent}); }

 private:
  Text& out_;
  char text_[160];
  size_t size_ = 0;
};

// All static: the core is larger than a stack.
firmware::ControllerConfiguration configuration;
uint8_t configuration_bytes[firmware::kConfigurationBytes];
alignas(firmware::EstimatorCore) uint8_t core_memory[sizeof(firmware::EstimatorCore)];

struct Cost {
  uint64_t total = 0;
  uint32_t count = 0, worst = 0;
  void add(uint32_t work) {
    ++count;
    total += work;
    if (work > worst) worst = work;
  }
};

void print_estimates(const firmware::Estimates& estimates, Text& out) {
  Line(out).add("estimates ").add(int64_t{estimates.unknown_count}).add(" rows ").add(int64_t{estimates.rows});
  for (int i = 0; i < estimates.unknown_count; ++i) {
    const firmware::ParameterEstimate& p = estimates.parameters[i];
    Line(out)
        .add(p.value)
        .add(" ")
        .add(p.std)
        .add(" ")
        .add(p.ci95_low)
        .add(" ")
        .add(p.ci95_high)
        .add(" ")
        .add(static_cast<int64_t>(p.status));
  }
}

bool read_configuration(Reader& reader) {
  for (const char* mark = "RIG1"; *mark != 0; ++mark) {
    uint8_t byte = 0;
    if (!reader.take(byte) || byte != static_cast<uint8_t>(*mark)) return false;
  }
  uint32_t length = 0;
  if (!reader.take(length) || length > sizeof configuration_bytes) return false;
  for (uint32_t i = 0; i < length; ++i)
    if (!reader.take(configuration_bytes[i])) return false;
  return firmware::decode(configuration_bytes, length, configuration);
}

bool read_sample(Reader& reader, firmware::RawSample& sample) {
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int quantity = 0; quantity < firmware::kQuantities; ++quantity) {
      if (!configuration.core.channels[node][quantity].present) continue;
      uint32_t code = 0;
      if (!reader.take(code)) return false;
      sample.code[node][quantity] = static_cast<int32_t>(code);
    }
  return true;
}

void print_cost(const Cost& push, const Cost& solve, Text& out) {
  if (push.total == 0) return;
  Line(out)
      .add("push: samples ")
      .add(int64_t{push.count})
      .add(" total ")
      .add(static_cast<int64_t>(push.total))
      .add(" worst ")
      .add(int64_t{push.worst});
  Line(out).add("solve: count ").add(int64_t{solve.count}).add(" worst ").add(int64_t{solve.worst});
}

}  // namespace

bool run_script(Bytes& script, Text& out, WorkCounter& counter, int detail) {
  static Reader reader(script);
  if (!read_configuration(reader)) return false;
  firmware::EstimatorCore& core =
      *new (core_memory) firmware::EstimatorCore(configuration.core, static_cast<firmware::CoreDetail>(detail));
  firmware::RawSample sample;
  Cost push, solve;
  uint8_t event = 0;
  while (reader.take(event) && event != 'Q') {
    if (event == 'S') {
      if (!read_sample(reader, sample)) return false;
      const uint32_t before = counter.now();
      core.push(sample);
      push.add(counter.now() - before);
      ++sample.sequence;
    } else if (event == 'W') {
      const uint32_t before = counter.now();
      const firmware::Estimates& estimates = core.solve();
      solve.add(counter.now() - before);
      print_estimates(estimates, out);
    } else if (event == 'L') {
      core.begin_level();
    } else if (event == 'E') {
      core.end_level();
    } else {
      return false;
    }
  }
  print_cost(push, solve, out);
  return event == 'Q';
}

}  // namespace bare_metal
