// Candidate forces that the score tests hold against the residual of the equations of motion, one row each.
//
// A place is where a force acts: a link of the rig, a pair of DOFs (or a DOF and ground) that no link joins, or a DOF. It
// has one or two equations of motion; a link's force stands in its first end's equation with +1, in the second's with -1.
// A probe is one force law at one place. The terms that the rig estimates are probes too (unknown >= 0): they say how
// much of a candidate the estimated coefficients take up.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"
#include "firmware/vocabulary/cause.hpp"

namespace firmware {

// Force law of a probe, over the elongation u and rate w of its place in units of their own rms (a power of two near it);
// on a DOF over its acceleration and force.
enum class Form : uint8_t {
  kElongation,            // u
  kElongationSquare,      // u^2
  kElongationCube,        // u^3
  kWithinGap,             // u, at most an eighth of its unit
  kBeyondStop,            // what u exceeds 5/4 of its unit by
  kConstant,              // 1
  kRate,                  // w
  kRateSquare,            // w |w|
  kRateCube,              // w^3
  kRateMagnitude,         // |w|
  kElongationSquareRate,  // u^2 w
  kSign,                  // sgn(w)
  kSignNarrow,            // exp(-|w| / v) sgn(w), v = 0.15 units
  kSignWide,              // the same, v = 0.5 units
  kSignElongation,        // |u| sgn(w)
  kAcceleration,          // a
  kJerk,                  // da/dt, per sample
  kForce,                 // f
  kForceWithinGap,        // f, at most an eighth of its unit, in units of that: its sign but for small forces
  kForceRate,             // df/dt, per sample
};
constexpr int kForms = static_cast<int>(Form::kForceRate) + 1;
constexpr bool needs_rate(Form form) { return form >= Form::kRate && form <= Form::kSignElongation; }

constexpr int kMaxPlaces = 2 * kMaxLinks + 2 * kMaxDofs;  // what does not fit is not tested
constexpr int kPlaceEquations = 2;
constexpr int kMaxPlaceColumns =
    kMaxUnknowns < 24 ? kMaxUnknowns : 24;  // unknowns in a place's equations; a place with more is not probed

// kBaseEnd: the base's end of a link, where its channels alone are the motion: late or with another gain than the DOFs'.
// In place of an equation of motion: kVelocityChannels, a DOF's velocity against the slope of its displacement;
// kAccelerationChannels, its acceleration against the slope of its velocity.
enum class PlaceKind : uint8_t { kLink, kNoLink, kDof, kBaseEnd, kVelocityChannels, kAccelerationChannels };
constexpr bool compares_channels(PlaceKind kind) { return kind >= PlaceKind::kVelocityChannels; }
// Its quantities are the DOF's acceleration and force, not elongation and rate.
constexpr bool moves_by_acceleration(PlaceKind kind) {
  return kind == PlaceKind::kDof || kind == PlaceKind::kAccelerationChannels;
}

struct Place {
  PlaceKind kind = PlaceKind::kLink;
  uint8_t link = 0;  // kLink, kBaseEnd
  uint8_t node_a = 0, node_b = kGroundNode;
  uint8_t equations = 0;
  uint8_t dof[kPlaceEquations] = {};
  int8_t sign[kPlaceEquations] = {};  // of the force in the equation
  // Unknowns that stand in these equations, and their sign in each (0: not there).
  uint8_t columns = 0;
  uint8_t unknown[kMaxPlaceColumns] = {};
  int8_t column_sign[kMaxPlaceColumns][kPlaceEquations] = {};
};

enum class Drift : uint8_t {
  kNone,
  kSteady,   // the time t
  kSettles,  // a rig that has run warm: 9/8 t / (t / T + 1/8), T the time of the level; as large as t at its end
};

struct Probe {
  Form form = Form::kElongation;
  uint8_t place = 0;
  int8_t unknown = -1;  // the estimated term it stands for; -1: a candidate
  Cause cause = Cause::kUnknown;
  uint8_t quantity = kNoQuantity;  // of the channel, where the cause is in the measurement
  // Not kNone: the force of the probe before it at this place with the same form, whose sums over stretches it shares, times a function
  // of the time since the level's start.
  Drift drift = Drift::kNone;
  bool drifts() const { return drift != Drift::kNone; }
  // Its sums: one per equation, one per column of the place, one of its own force; two of its slopes where noise is shared.
  uint16_t first_value = 0;
};

struct ProbePlan {
  Place place[kMaxPlaces];
  int place_count = 0;
  Probe probe[kMaxProbes];
  int probe_count = 0;
  int base_count = 0;    // the first ones: those of estimated terms
  int summed_count = 0;  // those with sums of their own; what drifts comes after them
  int value_count = 0;
  int slopes = 0;                           // 2 where signals share noise, else 0
  const Place& place_of(int number) const;  // of a probe
  // Sums of a probe, in their order.
  int values(const Probe& p) const { return place[p.place].equations + place[p.place].columns + 1 + slopes; }
  int own_value(const Probe& p) const { return p.first_value + place[p.place].equations + place[p.place].columns; }
};

// most_values: sums that there is room for; candidates at the end of the list are left out where they do not fit.
void make_probe_plan(const CoreConfiguration& configuration, int most_values, ProbePlan& plan);

}  // namespace firmware
