#include "conditions.hpp"

#include <stdexcept>

namespace hidden_rig {
namespace {

template <typename Change>
Condition made(const char* name, Change change) {
  Condition c;
  c.name = name;
  change(c);
  return c;
}

std::vector<Condition> table() {
  using C = Condition;
  return {
      made("random_clean", [](C& c) { c.noise = 0; }),
      made("random_1pct", [](C&) {}),
      made("random_5pct", [](C& c) { c.noise = 0.05; }),
      made("bits_12", [](C& c) { c.noise = 0, c.bits = 12; }),
      made("bits_16", [](C& c) { c.noise = 0, c.bits = 16; }),
      made("bits_24_1pct", [](C& c) { c.bits = 24; }),
      made("ar_0p5_1pct", [](C& c) { c.colour = Colour::kFirstOrder, c.memory = 0.5; }),
      made("ar_0p8_1pct", [](C& c) { c.colour = Colour::kFirstOrder, c.memory = 0.8; }),
      made("ar_0p8_5pct", [](C& c) { c.noise = 0.05, c.colour = Colour::kFirstOrder, c.memory = 0.8; }),
      made("pink_noise", [](C& c) { c.colour = Colour::kPink; }),
      made("student_t", [](C& c) { c.colour = Colour::kStudent; }),
      made("spikes", [](C& c) { c.colour = Colour::kSpikes; }),
      made("hum_50Hz", [](C& c) { c.hum_Hz = 50; }),
      made("hum_49p95Hz", [](C& c) { c.hum_Hz = 49.95; }),
      made("drift", [](C& c) { c.drift = 0.02; }),
      made("anti_alias_noise_before", [](C& c) { c.filter = AntiAlias::kNoiseBefore; }),
      made("anti_alias_noise_after", [](C& c) { c.filter = AntiAlias::kNoiseAfter; }),
      made("anti_alias_motion_only", [](C& c) { c.filter = AntiAlias::kMotionOnly; }),
      made("stepped_sine", [](C& c) { c.excitation = Excitation::kSteppedSine; }),
      made("sine_records", [](C& c) { c.excitation = Excitation::kSineRecords, c.records = 4, c.seconds = 6; }),
      made("log_sweep", [](C& c) { c.excitation = Excitation::kSweep; }),
      made("hammer", [](C& c) { c.excitation = Excitation::kHammer; }),
      made("hammer_5kHz", [](C& c) { c.excitation = Excitation::kHammer, c.rate_Hz = 5000, c.seconds = 10; }),
      made("free_decay", [](C& c) { c.excitation = Excitation::kFreeDecay, c.seconds = 3, c.records = 3; }),
      made("free_decay_to_rest",
           [](C& c) { c.excitation = Excitation::kFreeDecayToRest, c.seconds = 4, c.records = 3; }),
      made("moving_base", [](C& c) { c.excitation = Excitation::kBase; }),
      made("two_shakers", [](C& c) { c.excitation = Excitation::kTwoShakers, c.least_masses = 2; }),
      made("star", [](C& c) { c.topology = Topology::kStar, c.least_masses = 3, c.most_masses = 6; }),
      made("ring", [](C& c) { c.topology = Topology::kRing, c.least_masses = 3, c.most_masses = 6; }),
      made("all_grounded", [](C& c) { c.topology = Topology::kGrounded, c.least_masses = 2; }),
      made("eight_masses", [](C& c) { c.least_masses = c.most_masses = 8; }),
      made("twelve_masses", [](C& c) { c.least_masses = c.most_masses = 12; }),
      made("masses_springs_unknown", [](C& c) { c.masses_and_springs_unknown = true; }),
      made("stick_slip", [](C& c) { c.friction = Friction::kSticking; }),
      made("three_levels", [](C& c) { c.records = 3, c.seconds = 10, c.level_ratio = 2; }),
      made("warming_records", [](C& c) { c.records = 5, c.seconds = 8, c.warming = 0.15; }),
      made("rate_100Hz", [](C& c) { c.rate_Hz = 100, c.pace = 0.2, c.seconds = 60; }),
      made("rate_200Hz", [](C& c) { c.rate_Hz = 200; }),
      made("rate_10kHz", [](C& c) { c.rate_Hz = 10000, c.seconds = 10; }),
      made("seconds_2", [](C& c) { c.seconds = 2; }),
      made("seconds_120", [](C& c) { c.seconds = 120; }),
      made("rotation", [](C& c) { c.rotating = true; }),
      made("grams", [](C& c) { c.mass_scale = 1e-3; }),
      made("tonnes", [](C& c) { c.mass_scale = 1e3; }),
  };
}

}  // namespace

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> all = table();
  return all;
}

const Condition& condition(const std::string& name) {
  std::string known;
  for (const Condition& c : conditions()) {
    if (c.name == name) return c;
    known += " " + c.name;
  }
  throw std::invalid_argument("no condition is called " + name + ", expected one of" + known);
}

}  // namespace hidden_rig
