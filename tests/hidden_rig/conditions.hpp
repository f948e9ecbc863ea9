// The conditions under which rigs are drawn: one table, one row each, found by name.
#pragma once
#include <string>
#include <vector>

namespace hidden_rig {

enum class Excitation {
  kBand,             // Gaussian, 5 to 50 Hz (times the rig's pace)
  kSteppedSine,      // two levels x two frequencies after one another in one record
  kSineRecords,      // the same, a steady record each
  kSweep,            // logarithmic, 4 to 60 Hz
  kHammer,           // half sines or smooth pulses of 4 to 8 ms, every 1 to 2.5 s
  kFreeDecay,        // let go from a deflected shape; cut before it comes to rest
  kFreeDecayToRest,  // dry friction ends it well inside the record
  kBase,             // the base moves, no force
  kTwoShakers        // independent forces on two DOFs
};
enum class Topology { kChain, kStar, kRing, kGrounded };
enum class Colour { kWhite, kFirstOrder, kPink, kStudent, kSpikes };
enum class AntiAlias { kNone, kNoiseBefore, kNoiseAfter, kMotionOnly };  // fourth-order Butterworth
enum class Friction { kSome, kSticking };

struct Condition {
  std::string name;
  Excitation excitation = Excitation::kBand;
  Topology topology = Topology::kChain;
  int least_masses = 1, most_masses = 4;
  double noise = 0.01;  // of each channel's rms
  Colour colour = Colour::kWhite;
  double memory = 0;  // first order: what a sample keeps of the one before
  double hum_Hz = 0;  // 0.3 % of rms on every channel
  double drift = 0;   // of rms, slower than a tenth of the record, on every channel
  AntiAlias filter = AntiAlias::kNone;
  int bits = 0;  // over 1.25 times the channel's peak; 0: not rounded
  double rate_Hz = 1000;
  double pace = 1;  // frequencies of rig and excitation times this
  double seconds = 20;
  int records = 1;
  double level_ratio = 1;  // of a record to the one before
  double warming = 0;      // change of every viscous coefficient from the first record to the last, relative
  bool masses_and_springs_unknown = false;
  Friction friction = Friction::kSome;
  bool rotating = false;
  double mass_scale = 1;
};

const std::vector<Condition>& conditions();
const Condition& condition(const std::string& name);  // throws std::invalid_argument naming those that there are

}  // namespace hidden_rig
