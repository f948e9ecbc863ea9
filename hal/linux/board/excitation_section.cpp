#include "hal/linux/board/excitation_section.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/first_batches.hpp"
#include "hal/rig_file/whole_cycles.hpp"

namespace board {
namespace {

using firmware::Drive;
using firmware::ExcitationKind;
using firmware::ExcitationLevel;

Drive drive_of(double fraction) {
  return Drive::from_raw(static_cast<int32_t>(std::min(std::llround(fraction * 2147483648.0), 2147483647LL)));
}

uint32_t phase_step(double frequency_Hz, double rate_Hz) {
  return static_cast<uint32_t>(std::llround(4294967296.0 * frequency_Hz / rate_Hz));
}

uint32_t samples_of(double seconds, double rate_Hz) { return static_cast<uint32_t>(std::llround(seconds * rate_Hz)); }

// Energies are compared over blocks of whole cycles, half a second at least; random excitation needs longer ones and
// forgives more, because its energy scatters by itself.
void read_settling(const Section& section, double rate_Hz, double frequency_Hz, ExcitationLevel& level) {
  const bool random = level.kind == ExcitationKind::kRandomBand;
  double block_s = random ? 2.0 : 0.5;
  if (frequency_Hz > 0.0) block_s = std::ceil(block_s * frequency_Hz - 1e-9) / frequency_Hz;
  block_s = section.number("settle_block_s", block_s, 0.0, 60.0);
  level.settle.block_samples = samples_of(block_s, rate_Hz);
  level.settle.bound_per_mille =
      static_cast<uint16_t>(std::lround(section.number("settle_percent", random ? 40.0 : 2.0, 0.1, 100.0) * 10.0));
  level.settle.blocks =
      static_cast<uint8_t>(section.whole("settle_blocks", 4, 2, firmware::SettleDetector::kMaxBlocks));
  level.settle.floor_code = static_cast<uint32_t>(section.whole("settle_floor_code", 2, 0, 8388607));
  level.settle_limit_samples = samples_of(section.number("settle_limit_s", 60.0, 0.0, 3600.0), rate_Hz);
  level.skip_when_unsettled = section.flag("skip_when_unsettled", false);
}

ExcitationLevel read_level(const Section& section, double rate_Hz, double& frequency_Hz) {
  ExcitationLevel level;
  level.kind = static_cast<ExcitationKind>(section.choice("kind", {"sine", "random", "free_decay"}));
  if (!section.has("amplitude")) section.refuse("amplitude", "is missing, expected a fraction of full scale, 0 to 1");
  level.amplitude = drive_of(section.number("amplitude", 0.0, 1e-6, 1.0));
  const double nyquist = 0.5 * rate_Hz;
  frequency_Hz = 0.0;
  if (level.kind == ExcitationKind::kRandomBand) {
    for (const char* key : {"low_Hz", "high_Hz"})
      if (!section.has(key)) section.refuse(key, "is missing, expected both edges of the band");
    level.phase_step = phase_step(section.number("low_Hz", 0.0, 0.0, nyquist), rate_Hz);
    level.high_phase_step = phase_step(section.number("high_Hz", 0.0, 0.0, nyquist), rate_Hz);
    level.seed = static_cast<uint32_t>(section.whole("seed", 1, 1, 4294967295LL));
  } else {
    if (level.kind == ExcitationKind::kSine && !section.has("frequency_Hz"))
      section.refuse("frequency_Hz", "is missing, expected the frequency of the sine");
    frequency_Hz = section.number("frequency_Hz", 0.0, 0.0, nyquist);
    level.phase_step = phase_step(frequency_Hz, rate_Hz);
  }
  level.ramp_samples = std::max(1u, samples_of(section.number("ramp_s", 1.0, 0.0, 600.0), rate_Hz));
  level.measure_samples = samples_of(section.number("measure_s", 10.0, 0.01, 86400.0), rate_Hz);
  read_settling(section, rate_Hz, frequency_Hz, level);
  return level;
}

const char* explain(firmware::ProgrammeFault fault) {
  switch (fault) {
    case firmware::ProgrammeFault::kNone:
      return "";
    case firmware::ProgrammeFault::kTooManyLevels:
      return "has too many levels";
    case firmware::ProgrammeFault::kAmplitude:
      return "has an amplitude over the drive's limit, expected at most [drive] limit";
    case firmware::ProgrammeFault::kFrequency:
      return "has a frequency that cannot be made, expected less than half the sample rate and low_Hz < high_Hz";
    case firmware::ProgrammeFault::kSlew:
      return "changes faster than the drive may, expected a longer ramp_s, a lower frequency or a larger [drive] "
             "slew_per_s";
    case firmware::ProgrammeFault::kLength:
      return "measures nothing, expected measure_s of at least one sample";
    case firmware::ProgrammeFault::kCapacity:
      return "the rig needs more than this build of the core has room for";
    case firmware::ProgrammeFault::kSettle:
      return "cannot judge its settling, expected settle_block_s of at most 65535 samples and settle_limit_s above 0";
  }
  return "cannot be run";
}

}  // namespace

void read_excitation(const std::string& file, const toml::table& root, const Section& drive, double rate_Hz,
                     double cycle_Hz, firmware::ControllerConfiguration& controller) {
  firmware::ExcitationProgramme& programme = controller.programme;
  programme.limits.magnitude = drive_of(drive.number("limit", 1.0, 0.0, 1.0));
  programme.limits.step_per_sample = drive_of(std::min(1.0, drive.number("slew_per_s", 1e9, 1e-6, 1e9) / rate_Hz));
  const toml::table* table = sub_table(file, root, "excitation");
  const Section section(file, "excitation", table, {"start_at_boot", "level"});
  programme.start_at_boot = section.flag("start_at_boot", false);
  const auto tables = table == nullptr ? std::vector<const toml::table*>{}
                                       : rig_file::table_array({file, "excitation"}, *table, "level");
  if (tables.size() > static_cast<size_t>(firmware::kMaxLevels))
    section.refuse("level", "has " + std::to_string(tables.size()) + " entries, expected at most " +
                                std::to_string(firmware::kMaxLevels));
  bool one_frequency = !tables.empty(), all_free = !tables.empty();
  double common_Hz = 0.0;
  for (size_t i = 0; i < tables.size(); ++i) {
    const Section level(
        file, "excitation level " + std::to_string(i + 1), tables[i],
        {"kind", "amplitude", "frequency_Hz", "low_Hz", "high_Hz", "seed", "ramp_s", "measure_s", "settle_block_s",
         "settle_percent", "settle_blocks", "settle_floor_code", "settle_limit_s", "skip_when_unsettled"});
    double frequency_Hz = 0.0;
    programme.levels[i] = read_level(level, rate_Hz, frequency_Hz);
    programme.level_count = static_cast<uint8_t>(i + 1);
    uint8_t which = 0;
    const firmware::ProgrammeFault fault = firmware::check(programme, which);
    if (fault != firmware::ProgrammeFault::kNone) level.refuse("kind", explain(fault));
    const ExcitationKind kind = programme.levels[i].kind;
    one_frequency = one_frequency && kind == ExcitationKind::kSine && (i == 0 || frequency_Hz == common_Hz);
    all_free = all_free && kind == ExcitationKind::kFreeDecay;
    common_Hz = frequency_Hz;
  }
  firmware::WindowConfiguration& window = controller.core.window;
  if (all_free) window.mode = firmware::WindowMode::kFreeDecay;
  if (tables.empty() && cycle_Hz > 0.0) rig_file::set_whole_cycles(rate_Hz / cycle_Hz, window);
  if (one_frequency && rig_file::can_be_whole(rate_Hz / common_Hz))
    rig_file::set_whole_cycles(rate_Hz / common_Hz, window);
  if (tables.empty() || window.mode == firmware::WindowMode::kWholeCycles) return;
  uint32_t shortest = UINT32_MAX;
  for (int i = 0; i < programme.level_count; ++i) shortest = std::min(shortest, programme.levels[i].measure_samples);
  window.batch_samples = rig_file::first_batch_samples(shortest);
}

}  // namespace board
