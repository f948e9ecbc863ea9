#include "model.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/vocabulary/law.hpp"

namespace diagnosis::runs {

std::vector<Parameter> parameters_of(const Model& model) {
  std::vector<Parameter> list;
  for (size_t i = 0; i < model.size(); ++i) {
    if (!model[i].known && model[i].host < 0) list.push_back({i, 0});
    if (model[i].shape_free) list.push_back({i, 1});
    if (model[i].shape_free && model[i].term.kind == Kind::kCogging) list.push_back({i, 2});
  }
  return list;
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

LawValue law(Kind kind, double u, double w, double t_s, double shape, double shape2) {
  switch (kind) {
    case Kind::kStiffness:
    case Kind::kStiffnessError:
      return {u, 1, 0, 0};
    case Kind::kViscous:
    case Kind::kMissingViscous:
      return {w, 0, 1, 0};
    case Kind::kGravity:
    case Kind::kMissingGravity:
      return {std::sin(u), std::cos(u), 0, 0};
    case Kind::kCubicStiffness:
      return {u * u * u, 3 * u * u, 0, 0};
    case Kind::kQuadraticStiffness:
      return {u * u, 2 * u, 0, 0};
    case Kind::kBacklash: {  // what a spring of unit stiffness lacks
      const bool inside = std::abs(u) < shape;
      const double clip = std::clamp(u, -shape, shape);
      return {-clip, inside ? -1.0 : 0.0, 0, inside ? 0 : -clip};
    }
    case Kind::kEndStop: {
      const double clip = std::clamp(u, -shape, shape);
      const bool beyond = std::abs(u) > shape;
      return {u - clip, beyond ? 1.0 : 0.0, 0, beyond ? -clip : 0};
    }
    case Kind::kQuadraticDamping:
      return {w * std::abs(w), 0, 2 * std::abs(w), 0};
    case Kind::kCubicDamping:
      return {w * w * w, 0, 3 * w * w, 0};
    case Kind::kForceOffset:
      return {1, 0, 0, 0};
    case Kind::kAsymmetricViscous:
      return {std::abs(w), 0, w < 0 ? -1.0 : 1.0, 0};
    case Kind::kDisplacementDamping:
      return {u * u * w, 2 * u * w, u * u, 0};
    case Kind::kDriftingViscous: {
      const double gone = vocabulary::drifted_s(t_s, shape), e = 1e-3;
      const double slope = shape > 0 ? (vocabulary::drifted_s(t_s, shape * (1 + e)) - gone) / e : 0;
      return {gone * w, 0, gone, slope * w};
    }
    case Kind::kCogging:
    case Kind::kUnknownPitch: {
      const double k = 6.283185307179586 / shape, slope = std::cos(k * u + shape2);
      return {std::sin(k * u + shape2), k * slope, 0, -k * u * slope, slope};
    }
    default:
      return {};
  }
}

}  // namespace diagnosis::runs
