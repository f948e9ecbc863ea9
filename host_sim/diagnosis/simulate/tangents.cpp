#include "tangents.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr double kFarOut = 2;  // rms: 95 % of a random motion's way, and more than all of a sine's
constexpr int kPlaces = 4;     // to either side, where a slope is looked at: a spring that repeats is steep at any

double between_rms(const Prepared& record, int a, int b, Vec Guess::*quantity) {
  Vec sum = Vec::Zero(record.samples);
  for (const auto& [node, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
    if (node == -1 || node >= static_cast<int>(record.guess.size()) - 1)
      continue;  // what is hidden is not known to move
    const Guess& g = record.guess[node == -2 ? record.guess.size() - 1 : static_cast<size_t>(node)];
    if (g.given) sum += sign * (g.*quantity);
  }
  return std::sqrt(sum.squaredNorm() / static_cast<double>(std::max<Index>(1, record.samples)));
}

}  // namespace

bool is_curve(Kind kind) {
  return !is_linear(kind) && kind != Kind::kCoulomb && kind != Kind::kMissingCoulomb && kind != Kind::kStribeck &&
         kind != Kind::kPresliding && kind != Kind::kResonance;
}

LawValue steepest(Kind kind, double shape, double shape2, const Prepared& record, int a, int b) {
  const double u = kFarOut * between_rms(record, a, b, &Guess::x), w = kFarOut * between_rms(record, a, b, &Guess::v);
  LawValue most;
  for (int i = -kPlaces; i <= kPlaces; ++i)
    for (int j = -kPlaces; j <= kPlaces; ++j) {
      const LawValue at = law(kind, u * i / kPlaces, w * j / kPlaces, law_time(0, shape, record), shape, shape2);
      most.by_u = std::max(most.by_u, std::abs(at.by_u)), most.by_w = std::max(most.by_w, std::abs(at.by_w));
    }
  return most;
}

}  // namespace diagnosis::runs
