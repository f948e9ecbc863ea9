#include "start.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "hal/rig_file/effect_words.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kMostRows = 20000;  // of a DOF: first values need no more

double sign_of(double w, double spread) { return spread > 0 ? std::clamp(w / spread, -1.0, 1.0) : w < 0 ? -1 : 1; }

void require_scale(const System& system, const Model& model, const std::vector<Prepared>& records) {
  bool known = false, forced = false;
  for (const ModelTerm& t : model) known = known || (t.known && t.value != 0);
  for (const Prepared& p : records)
    for (const Vec& f : p.force) forced = forced || f.size() > 0;
  if (known || forced) return;
  (void)system;
  throw CannotAnswer(
      "without a force and without one known coefficient the equations only determine ratios: state one mass (or "
      "inertia), "
      "for example 1, and read every other coefficient per unit of it");
}

}  // namespace

Model rig_as_given(const System& s, const std::vector<Prepared>& records) {
  Model model;
  const auto add = [&](const Term& term, const rig_file::Coefficient& c) {
    if (!c.estimate && c.value == 0) return;
    ModelTerm t;
    t.term = term, t.known = !c.estimate, t.value = c.estimate ? 0 : c.value;
    model.push_back(t);
  };
  for (size_t i = 0; i < s.dofs(); ++i) {
    const int dof = static_cast<int>(i);
    add(on_dof(Kind::kMass, dof), s.rig.dofs[i].mass_kg);
    for (const rig_file::Effect& e : s.rig.dofs[i].effects) {
      Term term = on_dof(Kind::kMass, dof);
      if (!kind_of_word(e.kind, &term.kind)) continue;
      term.given = true;
      if (e.shape.count("resonance_Hz")) term.shape = e.shape.at("resonance_Hz");
      if (e.shape.count("damping_ratio")) term.shape2 = e.shape.at("damping_ratio");
      add(term, e.coefficient);
    }
  }
  for (size_t l = 0; l < s.known_links; ++l) {
    const rig_file::Link& link = s.links[l];
    const int i = static_cast<int>(l);
    add(on_link(Kind::kStiffness, i), link.stiffness_N_m);
    add(on_link(Kind::kViscous, i), link.viscous_N_s_m);
    add(on_link(Kind::kCoulomb, i), link.coulomb_N);
    add(on_link(Kind::kGravity, i), link.gravity_torque_N_m);
    for (const rig_file::Effect& e : link.effects) {
      Term term = on_link(Kind::kStiffness, i);
      if (!kind_of_word(e.kind, &term.kind)) continue;
      term.given = true;
      term.shape = rig_file::shape_of(e, 0, rig_file::link_rotates(s.rig, link));
      if (term.kind == Kind::kCogging || term.kind == Kind::kPresliding)
        term.shape2 = rig_file::shape_of(e, 1, rig_file::link_rotates(s.rig, link));
      add(term, e.coefficient);
    }
  }
  require_scale(s, model, records);
  return model;
}

namespace {

// The balance of forces of every DOF in one record's guessed motion: what each unknown number makes of it, and what is given.
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

// instruments' columns times the balance's, and times what is given; `own`: the balance's columns by themselves.
struct Moments {
  Mat gram, own;
  Vec right;
};

// What noise makes of a guess reaches over two smoothings on either side.
Index beyond_noise_of(const Prepared& r) { return 4 * r.smooth_half + 1; }

// delayed: the balance as it was some samples before is the instrument, else the balance itself.
void add_moments(const System& system, const Prepared& r, const Model& model, const std::vector<size_t>& unknown,
                 bool delayed, Moments& m) {
  const Balance balance(system, r, model, unknown);
  const Index p = static_cast<Index>(unknown.size()), n = static_cast<Index>(system.dofs());
  const Index stride = std::max<Index>(1, r.samples / kMostRows), lag = delayed ? beyond_noise_of(r) : 0;
  std::vector<Mat> rows(static_cast<size_t>(n), Mat(r.samples / stride + 1, p));
  std::vector<Mat> before(delayed ? rows : std::vector<Mat>());
  std::vector<Vec> target(static_cast<size_t>(n), Vec(r.samples / stride + 1));
  Mat columns(n, p), earlier(n, p);
  Vec given(n), ignored(n);
  Index count = 0;
  for (Index k = 2 + lag; k + 2 < r.samples; k += stride, ++count) {
    balance.at(k, columns, given);
    if (delayed) balance.at(k - lag, earlier, ignored);
    for (Index d = 0; d < n; ++d) {
      rows[static_cast<size_t>(d)].row(count) = columns.row(d), target[static_cast<size_t>(d)][count] = given[d];
      if (delayed) before[static_cast<size_t>(d)].row(count) = earlier.row(d);
    }
  }
  for (Index d = 0; d < n; ++d) {
    const auto a = rows[static_cast<size_t>(d)].topRows(count);
    const auto z = (delayed ? before : rows)[static_cast<size_t>(d)].topRows(count);
    const auto b = target[static_cast<size_t>(d)].head(count);
    // weighted by the size of the forces on this DOF
    double size = b.squaredNorm() + 1e-300;
    if (b.squaredNorm() <= 0) size = std::max(1e-300, a.colwise().squaredNorm().maxCoeff());
    m.gram += z.transpose() * a / size, m.right += z.transpose() * b / size;
    if (delayed) m.own += a.colwise().squaredNorm().transpose().asDiagonal().toDenseMatrix() / size;
  }
  if (!delayed) m.own = m.gram;
}

// Least squares shrinks what noise is added to: an inertia that nothing drives, with all its links, to nought. The motion of a
// while before has another noise.
bool any_mass(const Model& model, const std::vector<size_t>& unknown) {
  return std::any_of(unknown.begin(), unknown.end(), [&](size_t i) { return model[i].term.kind == Kind::kMass; });
}

}  // namespace

void start_values(const System& system, const std::vector<Prepared>& records, Model& model) {
  std::vector<size_t> unknown;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known) unknown.push_back(i);
  if (unknown.empty()) return;
  const Index p = static_cast<Index>(unknown.size());
  const bool delayed = any_mass(model, unknown);
  Moments m{Mat::Zero(p, p), Mat::Zero(p, p), Vec::Zero(p)};
  for (const Prepared& r : records) add_moments(system, r, model, unknown, delayed, m);
  const Vec scale = m.own.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Mat a = scale.asDiagonal() * m.gram * scale.asDiagonal();
  a.diagonal().array() += 1e-6;
  const Vec b = scale.asDiagonal() * m.right;
  const Vec z = delayed ? Vec(a.fullPivLu().solve(b)) : Vec(a.ldlt().solve(b));
  // what must be positive and is not starts from a tenth of what its column could carry alone
  for (Index i = 0; i < p; ++i) {
    ModelTerm& t = model[unknown[static_cast<size_t>(i)]];
    double value = z[i] * scale[i];
    if (positive(t.term.kind) && value <= 0) value = 0.1 * std::abs(m.right[i]) * scale[i] * scale[i];
    if ((t.term.kind == Kind::kViscous || t.term.kind == Kind::kCoulomb) && value < 0) value = 0;
    t.value = value;
  }
}

}  // namespace diagnosis::runs
