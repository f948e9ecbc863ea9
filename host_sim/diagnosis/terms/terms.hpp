// The terms of an equation of motion: those a rig file names, and the contract's vocabulary of effects it may lack.
#pragma once
#include <string>
#include <vector>

#include "../record/motion.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace diagnosis {

// Of a mass or a spring: sampling, and smoothing or the steps of a simulation, leave this share of its force wrong, noise or not.
constexpr double kKnownElastic = 3e-5;

enum class Kind {
  // of every rig file
  kMass,
  kStiffness,
  kViscous,
  kCoulomb,
  kGravity,
  // effects on a link
  kCubicStiffness,
  kQuadraticStiffness,
  kStiffnessError,
  kBacklash,
  kEndStop,
  kQuadraticDamping,
  kCubicDamping,
  kStribeck,
  kPresliding,
  kForceOffset,
  kAsymmetricViscous,
  kDisplacementDamping,
  kMissingViscous,
  kMissingCoulomb,
  kDriftingViscous,
  kCogging,
  kMissingGravity,
  // effects on a DOF
  kMassError,
  kResonance,
  kResonanceCos,
  kResonanceSin,
  // faults of a channel, seen in the equation of motion
  kForceDelay,
  kForceGain,
  kDeadBand,
  kForceHumCos50,
  kForceHumSin50,
  kForceHumCos60,
  kForceHumSin60,
  kBaseDelay,  // of all channels of the moving base
  // faults of a motion channel, seen in what a simulation gives for it
  kChannelDelay,
  kChannelGain,
  kHumCos,
  kHumSin,
  // outside the vocabulary: its presence makes a residual unknown
  kUnknownPitch
};

inline bool is_force_hum(Kind kind) { return kind >= Kind::kForceHumCos50 && kind <= Kind::kForceHumSin60; }
inline bool of_motion_channel(Kind kind) { return kind >= Kind::kBaseDelay && kind <= Kind::kHumSin; }
inline bool of_force_sensor(Kind kind) { return kind >= Kind::kForceDelay && kind <= Kind::kForceHumSin60; }

// The row of the vocabulary that a kind is named after; of kUnknownPitch that of the law it has.
firmware::EffectKind effect_of(Kind kind);
const char* word_of(Kind kind);  // of that row
bool kind_of_word(const std::string& word, Kind* kind);

struct Term {
  Kind kind = Kind::kMass;
  int link = -1;  // index into the system's links, or -1
  int dof = -1;   // index from 0, or -1
  double shape =
      0;  // gap m, Stribeck velocity m/s, presliding length m, resonance Hz, time constant of a drift s (0: straight), delay s of a force (0: its first order)
  double shape2 =
      0;  // resonance: damping ratio; cogging: phase rad; presliding: time constant of the bristles' own damping s (LuGre; 0: Dahl)
  bool smooth = false;  // base terms: from the smoothed motion (where the coefficient is fitted)
  bool given = false;   // an effect of the rig file: backlash and presliding as forces of their own
  int record = -1;      // only in this record (what is left of a resonance's start), or -1
  int quantity = -1;    // a motion channel's fault: 0 displacement, 1 velocity, 2 acceleration of `dof`; -1: the force
  bool operator==(const Term& o) const { return same_place(o) && shape == o.shape && shape2 == o.shape2; }
  bool same_place(const Term& o) const {
    return kind == o.kind && link == o.link && dof == o.dof && record == o.record && quantity == o.quantity;
  }
};

inline Term on_link(Kind kind, int link, double shape = 0) { return {kind, link, -1, shape, 0}; }
inline Term on_dof(Kind kind, int dof, double shape = 0, double shape2 = 0) { return {kind, -1, dof, shape, shape2}; }

// The rig file's links first, then those it might lack (every pair of DOFs, every DOF to the ground).
struct System {
  rig_file::RigModel rig;
  std::vector<rig_file::Link> links;
  size_t known_links = 0;  // links.size() of the rig file
  size_t dofs() const { return rig.dofs.size(); }
};
// ground_known: links to the ground that the rig file lacks may be told.
System make_system(const rig_file::RigModel& rig, bool ground_known = true);

// Where a force acts: with + on one DOF (index from 0), with - on another; -1: on none (ground, base).
struct Place {
  int plus = -1, minus = -1;
  bool operator<(const Place& o) const { return plus != o.plus ? plus < o.plus : minus < o.minus; }
};
Place place_of_link(const System& system, size_t link);
Place place_of_force(const System& system, const Term& term);

// Elongation and rate of a link, from the linear or the smoothed motion. The base is the motion after the last DOF.
struct LinkMotion {
  Series u, w;  // linear
  Series smooth_u, smooth_w;
  Series sign;                              // expected sgn of smooth_w
  double w_error = 0;                       // standard deviation of smooth_w
  double u_peak = 0, u_rms = 0, w_rms = 0;  // over the equation's span
};
LinkMotion link_motion(const System& system, const FusedRecord& record, size_t link);

// By how much a force that reads `delay_s` late falls short of the true one, per second of delay; a delay of nought: the
// limit, the slope with its sign turned. Right where the record's outer weight is 1.
Series lateness(const Series& force, double delay_s, const FusedRecord& record);

// A term with coefficient one as a force over time (positive against the motion, as in M a + K x + ... = f).
Series term_force(const Term& term, const FusedRecord& record, const std::vector<LinkMotion>& links);

}  // namespace diagnosis
