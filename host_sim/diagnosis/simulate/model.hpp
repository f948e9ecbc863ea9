// The terms of a model under test and their free numbers.
#pragma once
#include <vector>

#include "../motion/prepared.hpp"
#include "../terms/terms.hpp"

namespace diagnosis::runs {

struct ModelTerm {
  Term term;
  double value = 0;  // SI units
  double std = 0;    // 0: not fitted
  bool known = true;
  bool added = false;       // not of the rig file
  bool corrects = false;    // a number that the rig file states, of a kind that is positive: of either sign
  bool shape_free = false;  // term.shape is fitted too, in its logarithm
  bool shape2_free =
      false;      // term.shape2 too: a phase as it is, a time constant and a damping ratio in their logarithm
  int host = -1;  // acts in place of this term's force, with its coefficient
};
using Model = std::vector<ModelTerm>;

struct Parameter {
  size_t term = 0;
  int shape = 0;  // 0: the coefficient; 1: the logarithm of term.shape; 2: term.shape2, see ModelTerm
};
std::vector<Parameter> parameters_of(const Model& model);
// Changes them, but no shape and no positive number by more than a linearisation bears.
void step_parameters(Model& model, const Vec& change);

// Nothing has inertia: the motion is given and forces answer to it.
bool massless(const Model& model);
// How far bristles that were bent by z are after a way in one direction: dz = (1 - z sgn(way)) dway / length (Dahl).
double bent_on(double z, double way, double length);

// Whether a negative coefficient has no physical sense.
bool positive(Kind kind);

// Time constant of a drift from record to record, constant within each: warming.
constexpr double kAcrossRecords = -1;
// The time that a law with this shape counts, from that within a record.
inline double law_time(double t_s, double shape, const Prepared& record) {
  return shape == kAcrossRecords ? record.middle_s : t_s;
}

// Force of a law with coefficient one (positive against the motion) and its slopes. t_s: time since the record's start.
struct LawValue {
  double force = 0, by_u = 0, by_w = 0, by_log_shape = 0, by_shape2 = 0;
};
bool is_linear(Kind kind);  // in elongation and rate, without shapes
// Of bristles bent by z, and its slope in z. by_shape2: per unit of the logarithm of their time constant (a resonance: of its damping ratio).
LawValue bristles(double w, double z, double length, double time_s, double& by_z);
LawValue law(Kind kind, double u, double w, double t_s, double shape, double shape2);

}  // namespace diagnosis::runs
