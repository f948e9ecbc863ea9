// What there is to know of an effect: the fields of a row of the vocabulary. No field has a default, so that a row that
// leaves one out does not compile. Integers and words alone: the laws in double are in host_sim/vocabulary, those in fixed
// point in firmware/links.
#pragma once
#include <cstdint>

#include "firmware/vocabulary/kinds.hpp"

namespace firmware {

struct Word {  // names it everywhere: rig file, JSON, DBC, tables, pages
  const char* text;
  constexpr explicit Word(const char* t) : text(t) {}
};
struct Formula {  // the force with coefficient q, as the documentation prints it
  const char* text;
  constexpr explicit Formula(const char* t) : text(t) {}
};
struct Sentence {  // what it is, for somebody who never heard the word
  const char* text;
  constexpr explicit Sentence(const char* t) : text(t) {}
};
struct Experiment {  // what sets it apart from those that look like it; "" where nothing has to be said
  const char* text;
  constexpr explicit Experiment(const char* t) : text(t) {}
};

enum class EffectPlace : uint8_t {
  kDof,           // on one DOF
  kLink,          // between two ends: acts on a with -1, on b with +1
  kChannel,       // in the reading of any channel; of a force channel it stands in the equation of motion
  kForceChannel,  // of force channels alone
};

enum class EffectRole : uint8_t {
  kOwnTerm,      // every rig file has it, with a key of its own
  kCorrection,   // of an own term that the file has wrong or lacks: the same force
  kExtension,    // a force of another shape
  kSensorFault,  // the rig is right, the reading is not
  kDriveFault,   // the reading is right, the force that acts is another
};

// How a rig file writes it.
struct RigFileForm {
  enum class As : uint8_t { kKey, kEffectTable, kChannelKey, kNotWritten };
  As as;
  const char* key;           // without its unit: "stiffness"; of a channel: "delay_us", whole
  const char* rotating_key;  // of a rotating DOF; nullptr: the same
  static constexpr RigFileForm own_key(const char* k, const char* rotating = nullptr) {
    return {As::kKey, k, rotating};
  }
  static constexpr RigFileForm effect_table() { return {As::kEffectTable, nullptr, nullptr}; }
  static constexpr RigFileForm channel_key(const char* k) { return {As::kChannelKey, k, nullptr}; }
  static constexpr RigFileForm not_written() { return {As::kNotWritten, nullptr, nullptr}; }
};

struct Unit {  // of translation and of rotation; nullptr: does not stand on such a DOF; "channel": the channel's own
  const char* translating;
  const char* rotating;
  constexpr Unit(const char* t, const char* r) : translating(t), rotating(r) {}
  constexpr const char* of(bool rotates) const { return rotates ? rotating : translating; }
};

enum class Sign : uint8_t { kNotNegative, kAny };  // what physics allows

// What a range is measured in, so that it holds for grams and for tonnes.
enum class RangeOf : uint8_t {
  kElongationPeak,  // largest |u| of the link in the record
  kElongationRms,
  kRateRms,
  kSlideTime,     // presliding length over the rms rate
  kDuration,      // of the record, s
  kSamplingRate,  // Hz
  kForcePeak,     // largest |reading| of the channel
  kOne,           // the parameter's own unit
};
struct Range {  // from low to high millionths of what it is measured in
  RangeOf of;
  int32_t low_millionths, high_millionths;
  constexpr Range(RangeOf o, int32_t low, int32_t high) : of(o), low_millionths(low), high_millionths(high) {}
};

// A parameter in which the force is not linear.
struct ShapeParameter {
  const char* key;   // in a rig file, without its unit: "gap"
  const char* name;  // in results: "backlash_gap"
  Unit unit;
  Range range;  // in which a search looks for it
  bool zero_allowed;
  bool may_be_left_out;  // is 0 then
  bool in_core;          // false: with it (other than 0) the core cannot estimate the coefficient
  constexpr ShapeParameter(const char* k, const char* n, Unit u, Range r, bool zero, bool left_out, bool core)
      : key(k), name(n), unit(u), range(r), zero_allowed(zero), may_be_left_out(left_out), in_core(core) {}
};
constexpr int kMaxShapes = 2;
constexpr ShapeParameter kNoParameter(nullptr, nullptr, Unit("", ""), Range(RangeOf::kOne, 0, 0), false, true, true);
struct Shapes {
  ShapeParameter at[kMaxShapes];
  int count;
  constexpr explicit Shapes(ShapeParameter one) : at{one, kNoParameter}, count(1) {}
  constexpr Shapes(ShapeParameter one, ShapeParameter two) : at{one, two}, count(2) {}
  static constexpr Shapes none() { return Shapes(); }

 private:
  constexpr Shapes() : at{kNoParameter, kNoParameter}, count(0) {}
};

enum class Memory : uint8_t {
  kNone,
  kBristles,    // one state, follows the elongation's path
  kTime,        // counts from the level's (record's) start
  kHiddenMass,  // two states: where a mass that no sensor sees is, and how fast
};

enum class Events : uint8_t {
  kNone,
  kRateZero,  // not smooth at w = 0
  kGap,       // not smooth at u = -shape and u = +shape
};

enum class AtRest : uint8_t {
  kPasses,  // what the law says at w = 0
  kHolds,   // carries up to its coefficient while its ends stand still
};

// Of the force with coefficient 1 along a motion: a force of place times the elongation, any other times the rate.
enum class Work : uint8_t {
  kOneSign,     // never changes its sign: a link that moves adds it up, noise does not
  kEitherSign,  // cancels over a motion that is alike in both directions
};

struct Nature {
  bool conservative;  // a force of place (or of acceleration) alone: gives back what it takes
  Memory memory;
  Events events;
  AtRest at_rest;
  Work work;
  constexpr Nature(bool c, Memory m, Events e, AtRest r, Work w)
      : conservative(c), memory(m), events(e), at_rest(r), work(w) {}
  // A motion seen backwards has the other rate at the same place: what dissipates seems to push.
  constexpr bool turns_with_time() const { return !conservative && memory == Memory::kNone && work == Work::kOneSign; }
};

struct CoreTerm {  // the column of the core that carries it
  bool estimable;
  TermKind term;  // where estimable
  static constexpr CoreTerm of(TermKind kind) { return {true, kind}; }
  static constexpr CoreTerm none() { return {false, TermKind::kMass}; }
};

struct CanCause {  // its number in the diagnosis frame, for good; 0: never a cause
  uint8_t number;
  constexpr explicit CanCause(uint8_t n) : number(n) {}
};

struct EffectRow {
  EffectKind kind;
  Word word;
  EffectPlace place;
  EffectRole role;
  RigFileForm written;
  Unit unit;  // of the coefficient
  Sign sign;
  Shapes shape;
  Nature nature;
  CoreTerm core;
  CanCause can;
  Formula formula;
  Sentence sentence;
  Experiment experiment;
};

}  // namespace firmware
