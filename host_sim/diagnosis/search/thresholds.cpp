// What an effect must gain to be named.
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <set>

#include "candidates.hpp"

namespace diagnosis {
namespace {

constexpr double kFalseAlarm = 0.002;  // of records in which nothing is hidden

// Chi-squared of one degree of freedom that chance passes with this probability.
double passed_by_chance(double probability) { return quantile(complement(boost::math::chi_squared(1), probability)); }

// Friction that is smoothed a little wrong looks like any of these.
bool law_of_rate(Kind kind) {
  return CandidateBank::friction_shape(kind) || kind == Kind::kQuadraticDamping || kind == Kind::kCubicDamping;
}

}  // namespace

double CandidateBank::chance_threshold() const {
  const System& s = rows_.system();
  std::set<std::tuple<Kind, int, int>> places;
  for (const auto& column : columns_)  // shapes share one: each pays its penalty
    if (!friction_shape(column->term.kind)) places.insert({column->term.kind, column->term.link, column->term.dof});
  size_t fitted = 0;  // what the rig file leaves open cannot also be missing or wrong
  for (const rig_file::Dof& d : s.rig.dofs) fitted += d.mass_kg.estimate;
  for (size_t l = 0; l < s.known_links; ++l)
    fitted += s.links[l].stiffness_N_m.estimate + s.links[l].viscous_N_s_m.estimate + s.links[l].coulomb_N.estimate;
  const size_t open = places.size() > fitted ? places.size() - fitted : 1;
  return passed_by_chance(kFalseAlarm / static_cast<double>(open));
}

// Friction near velocity reversals is known to some percent only: an effect beside it must bring more than that, or show
// with the reversals left out of account.
double CandidateBank::reversal_doubt(const std::vector<ActiveTerm>& model, const Term& t) const {
  double largest = 0;
  const auto& links = rows_.system().links;
  const auto touches = [&](const rig_file::Link& l, int dof) { return dof > 0 && (l.a == dof || l.b == dof); };
  for (const ActiveTerm& a : model) {
    const Term& own = a.term;
    if ((own.kind != Kind::kCoulomb && own.kind != Kind::kMissingCoulomb && own.kind != Kind::kStribeck) ||
        !(a.std > 0))
      continue;
    const rig_file::Link& l = links[static_cast<size_t>(own.link)];
    const bool near = t.dof >= 0 ? touches(l, t.dof + 1)
                                 : touches(l, links[static_cast<size_t>(t.link)].a) ||
                                       touches(l, links[static_cast<size_t>(t.link)].b);
    if (near) largest = std::max(largest, std::pow(a.value / a.std, 2));
  }
  if (friction_shape(t.kind)) return 1e-4 * largest;
  if (rows_.reversals() == Rows::Reversals::kNarrow) return 1e-3 * largest;
  return 1e-5 * largest * std::max(1.0, 1e-6 * largest);  // never trusted to better than a thousandth
}

double CandidateBank::strictness(Kind kind) const {
  // integrated motion drifts, and drift looks like much, most of all like a hidden mass with a spring of its own
  const double alone = !rows_.absolute()   ? (kind == Kind::kResonance ? 80 : 4)
                       : rows_.redundant() ? 1
                       : law_of_rate(kind) ? 6
                                           : 2.5;
  return alone * (rows_.coarse() && !friction_shape(kind) ? 2.6 : 1);
}

}  // namespace diagnosis
