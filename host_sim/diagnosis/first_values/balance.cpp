#include "balance.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

double sign_of(double w, double spread) { return spread > 0 ? std::clamp(w / spread, -1.0, 1.0) : w < 0 ? -1 : 1; }

// At one sample: what each unknown number makes of the balances, and what is given.
class Balance {
 public:
  Balance(const System& system, const Prepared& record, const Model& model, const std::vector<size_t>& unknown)
      : system_(system), r_(record), model_(model), unknown_(unknown) {}

  // DOF by DOF; columns: per unknown number.
  void at(Index k, Mat& columns, Vec& given) const {
    columns.setZero();
    for (Index d = 0; d < given.size(); ++d)
      given[d] = r_.force[static_cast<size_t>(d)].size() ? r_.force[static_cast<size_t>(d)][k] : 0;
    for (size_t i = 0; i < model_.size(); ++i) {
      const Term& t = model_[i].term;
      const auto known = std::find(unknown_.begin(), unknown_.end(), i);
      const auto put = [&](int dof, double f) {
        if (dof < 1) return;
        if (known != unknown_.end())
          columns(dof - 1, known - unknown_.begin()) += f;
        else
          given[dof - 1] -= model_[i].value * f;
      };
      if (t.kind == Kind::kMass || t.kind == Kind::kMassError) {
        put(t.dof + 1, value(t.dof + 1, 2, k));
      } else if (t.link >= 0) {
        const double f = force_of(t, k);
        put(system_.links[static_cast<size_t>(t.link)].a, f), put(system_.links[static_cast<size_t>(t.link)].b, -f);
      }
    }
  }

 private:
  double value(int end, int quantity, Index at) const {
    if (end == rig_file::kGround) return 0.0;
    const Guess& g = r_.guess[end == rig_file::kBase ? system_.dofs() : static_cast<size_t>(end - 1)];
    return quantity == 0 ? g.x[at] : quantity == 1 ? g.v[at] : g.a[at];
  }

  double force_of(const Term& t, Index k) const {
    const rig_file::Link& l = system_.links[static_cast<size_t>(t.link)];
    const double u = value(l.a, 0, k) - value(l.b, 0, k), w = value(l.a, 1, k) - value(l.b, 1, k);
    const double spread =
        0.5 * std::abs(value(l.a, 1, k + 1) - value(l.b, 1, k + 1) - value(l.a, 1, k - 1) + value(l.b, 1, k - 1));
    const bool friction = t.kind == Kind::kCoulomb || t.kind == Kind::kStribeck || t.kind == Kind::kPresliding;
    return friction ? sign_of(w, spread) : law(t.kind, u, w, r_.time_s(k), t.shape, t.shape2).force;
  }

  const System& system_;
  const Prepared& r_;
  const Model& model_;
  const std::vector<size_t>& unknown_;
};

// The unknown numbers that act on a DOF.
std::vector<Index> acting_on(size_t dof, const System& system, const Model& model, const std::vector<size_t>& unknown) {
  std::vector<Index> list;
  const int end = static_cast<int>(dof) + 1;
  for (size_t i = 0; i < unknown.size(); ++i) {
    const Term& t = model[unknown[i]].term;
    const bool there = t.link >= 0 ? system.links[static_cast<size_t>(t.link)].a == end ||
                                         system.links[static_cast<size_t>(t.link)].b == end
                                   : t.dof + 1 == end;
    if (there) list.push_back(static_cast<Index>(i));
  }
  return list;
}

}  // namespace

std::vector<DofBalance> balances_of(const System& system, const Prepared& record, const Model& model,
                                    const std::vector<size_t>& unknown, Index stride, Index count) {
  std::vector<DofBalance> list;
  for (size_t d = 0; d < system.dofs(); ++d) {
    const std::vector<Index> acting = acting_on(d, system, model, unknown);
    list.push_back({acting, Mat(count, static_cast<Index>(acting.size())), Vec(count)});
  }
  const Balance balance(system, record, model, unknown);
  Mat columns(static_cast<Index>(system.dofs()), static_cast<Index>(unknown.size()));
  Vec given(columns.rows());
  for (Index i = 0; i < count; ++i) {
    balance.at(kFirstBalanced + i * stride, columns, given);
    for (size_t d = 0; d < list.size(); ++d) {
      const Index dof = static_cast<Index>(d);
      list[d].given[i] = given[dof];
      for (size_t j = 0; j < list[d].acting.size(); ++j)
        list[d].rows(i, static_cast<Index>(j)) = columns(dof, list[d].acting[j]);
    }
  }
  return list;
}

}  // namespace diagnosis::runs
