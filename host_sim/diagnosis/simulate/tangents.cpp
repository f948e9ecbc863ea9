#include "tangents.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/link_motion.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kFarOut = 2;  // rms: 95 % of a random motion's way, and more than all of a sine's
constexpr int kPlaces = 4;     // to either side, where a slope is looked at: a spring that repeats is steep at any

// The link that lies between two nodes.
rig_file::Link between(int a, int b) {
  const auto end_of = [](int node) { return node >= 0 ? node + 1 : node == -2 ? rig_file::kBase : rig_file::kGround; };
  rig_file::Link link;
  link.a = end_of(a), link.b = end_of(b);
  return link;
}

double rms(const Vec& y) { return std::sqrt(y.squaredNorm() / static_cast<double>(std::max<Index>(1, y.size()))); }

}  // namespace

bool is_curve(Kind kind) {
  return !is_linear(kind) && kind != Kind::kCoulomb && kind != Kind::kMissingCoulomb && kind != Kind::kStribeck &&
         kind != Kind::kPresliding && kind != Kind::kResonance;
}

LawValue steepest(Kind kind, double shape, double shape2, const Prepared& record, int a, int b) {
  const rig_file::Link link = between(a, b);
  const double u = kFarOut * rms(motion_of(link, record, &Guess::x)),
               w = kFarOut * rms(motion_of(link, record, &Guess::v));
  LawValue most;
  for (int i = -kPlaces; i <= kPlaces; ++i)
    for (int j = -kPlaces; j <= kPlaces; ++j) {
      const LawValue at = law(kind, u * i / kPlaces, w * j / kPlaces, law_time(0, shape, record), shape, shape2);
      most.by_u = std::max(most.by_u, std::abs(at.by_u)), most.by_w = std::max(most.by_w, std::abs(at.by_w));
    }
  return most;
}

}  // namespace diagnosis::runs
