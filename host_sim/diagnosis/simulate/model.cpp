#include "model.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/vocabulary/law_table.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLongestStep = 0.5;  // of a shape's logarithm
// Of a resonance's damping: what is damped beyond turns no more, and what is damped less no record is long enough to tell.
constexpr double kLeastRatio = 1e-4, kMostRatio = 1;
constexpr double kLeastShare = 0.3;  // of a positive number, that one step may leave of it

}  // namespace

std::vector<Parameter> parameters_of(const Model& model) {
  std::vector<Parameter> list;
  for (size_t i = 0; i < model.size(); ++i) {
    if (!model[i].known && model[i].host < 0) list.push_back({i, 0});
    if (model[i].shape_free) list.push_back({i, 1});
    if (model[i].shape2_free) list.push_back({i, 2});
  }
  return list;
}

bool massless(const Model& model) {
  return std::none_of(model.begin(), model.end(),
                      [](const ModelTerm& t) { return t.term.kind == Kind::kMass && (t.value > 0 || !t.known); });
}

double bent_on(double z, double way, double length) {
  const double sign = way < 0 ? -1 : 1;
  return sign + (z - sign) * std::exp(-std::abs(way) / length);
}

bool positive(Kind kind) {
  switch (kind) {
    case Kind::kMass:
    case Kind::kStiffness:
    case Kind::kResonance:
    case Kind::kStribeck:
    case Kind::kEndStop:
    case Kind::kMissingViscous:
    case Kind::kMissingCoulomb:
    case Kind::kPresliding:
    case Kind::kMissingGravity:
      return true;
    default:
      return false;
  }
}

bool is_linear(Kind kind) {
  const auto force = vocabulary::law_of(effect_of(kind)).force;
  return force == vocabulary::laws::elongation || force == vocabulary::laws::rate;
}

LawValue bristles(double w, double z, double length, double time_s, double& by_z) {
  constexpr firmware::EffectKind kBristles = firmware::EffectKind::kPreslidingHysteresis;
  const vocabulary::Shape shapes{{length, time_s}};
  vocabulary::Point at = vocabulary::point(kBristles, 0, w, 0, shapes);
  at.z[0] = z;
  const vocabulary::Force f = vocabulary::force(kBristles, at, shapes);
  by_z = f.slope.z[0];
  return {f.value, 0, f.slope.w, length * f.slope.shape[0], time_s * f.slope.shape[1]};
}

LawValue law(Kind kind, double u, double w, double t_s, double shape, double shape2) {
  const firmware::EffectKind effect = effect_of(kind);
  const vocabulary::Shape shapes{{shape, shape2}};
  const vocabulary::Force f = vocabulary::force(effect, vocabulary::point(effect, u, w, t_s, shapes), shapes);
  return {f.value, f.slope.u, f.slope.w, shape * f.slope.shape[0], f.slope.shape[1]};
}

void step_parameters(Model& model, const Vec& change) {
  const std::vector<Parameter> parameters = parameters_of(model);
  for (size_t i = 0; i < parameters.size(); ++i) {
    ModelTerm& t = model[parameters[i].term];
    const double d = change[static_cast<Index>(i)];
    if (parameters[i].shape == 2) {
      const double step = std::clamp(d, -kLongestStep, kLongestStep);
      t.term.kind == Kind::kCogging ? t.term.shape2 += step : t.term.shape2 *= std::exp(step);
      if (t.term.kind == Kind::kResonance) t.term.shape2 = std::clamp(t.term.shape2, kLeastRatio, kMostRatio);
    } else if (parameters[i].shape) {
      t.term.shape *= std::exp(std::clamp(d, -kLongestStep, kLongestStep));
    } else {
      const double next = t.value + d;
      t.value = positive(t.term.kind) && !t.corrects && t.value > 0 ? std::max(next, kLeastShare * t.value) : next;
    }
  }
}

}  // namespace diagnosis::runs
