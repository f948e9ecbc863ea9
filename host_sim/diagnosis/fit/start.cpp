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

// Normal equations of the unknown numbers, each DOF's balance weighted by its own size.
struct Moments {
  Mat gram;
  Vec right;
};

// What noise makes of a guess reaches over two smoothings on either side.
Index beyond_noise_of(const Prepared& r) { return 4 * r.smooth_half + 1; }

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

Mat solved(const Mat& gram, const Mat& right) {
  const Vec scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Mat a = scale.asDiagonal() * gram * scale.asDiagonal();
  a.diagonal().array() += 1e-6;
  return scale.asDiagonal() * a.ldlt().solve(scale.asDiagonal() * right);
}

// Least squares shrinks what noise is added to: an inertia that nothing drives, with all its links, to nought. The motion a while
// before and after has another noise, and the force has none of the motion's: what they tell of each column stands for it.
Mat instruments_of(const Mat& rows, const std::vector<Vec>& forces, Index lag) {
  const Index count = rows.rows() - 2 * lag, p = rows.cols();
  Mat z(count, 2 * p + 3 * static_cast<Index>(forces.size()));
  z.leftCols(p) = rows.topRows(count), z.middleCols(p, p) = rows.bottomRows(count);
  Index at = 2 * p;
  for (const Vec& f : forces)
    for (Index from : {Index{0}, lag, 2 * lag}) z.col(at++) = f.segment(from, count);
  return z;
}

// instruments: of the columns, not the columns themselves.
void add_moments(const System& system, const Prepared& r, const Model& model, const std::vector<size_t>& unknown,
                 bool instruments, Moments& m) {
  const Balance balance(system, r, model, unknown);
  const Index stride = std::max<Index>(1, r.samples / kMostRows), count = (r.samples - 4 + stride - 1) / stride;
  const Index lag = instruments ? (beyond_noise_of(r) + stride - 1) / stride : 0;
  std::vector<std::vector<Index>> acting;
  std::vector<Mat> rows;
  std::vector<Vec> target, forces;
  for (size_t d = 0; d < system.dofs(); ++d) {
    acting.push_back(acting_on(d, system, model, unknown));
    rows.push_back(Mat(count, static_cast<Index>(acting[d].size()))), target.push_back(Vec(count));
    if (r.force[d].size()) forces.push_back(Vec::Map(r.force[d].data() + 2, count, Eigen::InnerStride<>(stride)));
  }
  Mat columns(static_cast<Index>(system.dofs()), static_cast<Index>(unknown.size()));
  Vec given(columns.rows());
  for (Index i = 0; i < count; ++i) {
    balance.at(2 + i * stride, columns, given);
    for (size_t d = 0; d < rows.size(); ++d) {
      target[d][i] = given[static_cast<Index>(d)];
      for (size_t j = 0; j < acting[d].size(); ++j)
        rows[d](i, static_cast<Index>(j)) = columns(static_cast<Index>(d), acting[d][j]);
    }
  }
  for (size_t d = 0; d < rows.size(); ++d) {
    if (acting[d].empty() || count <= 2 * lag) continue;
    const Mat a = rows[d].middleRows(lag, count - 2 * lag);
    const Vec b = target[d].segment(lag, count - 2 * lag);
    // weighted by the size of the forces on this DOF
    double size = b.squaredNorm() + 1e-300;
    if (b.squaredNorm() <= 0) size = std::max(1e-300, a.colwise().squaredNorm().maxCoeff());
    Mat told = a;
    if (instruments) {
      const Mat z = instruments_of(rows[d], forces, lag);
      told = z * solved(z.transpose() * z, z.transpose() * a);
    }
    const Mat gram = told.transpose() * told / size;
    const Vec right = told.transpose() * b / size;
    for (size_t i = 0; i < acting[d].size(); ++i) {
      m.right[acting[d][i]] += right[static_cast<Index>(i)];
      for (size_t j = 0; j < acting[d].size(); ++j)
        m.gram(acting[d][i], acting[d][j]) += gram(static_cast<Index>(i), static_cast<Index>(j));
    }
  }
}

bool any_mass(const Model& model, const std::vector<size_t>& unknown) {
  return std::any_of(unknown.begin(), unknown.end(), [&](size_t i) { return model[i].term.kind == Kind::kMass; });
}

// Nothing of that kind can be nought: what came out so, at a DOF that neither a force nor its own motion tells of, starts as the
// mean of its likes in the rig.
void fill_from_likes(Model& model) {
  for (ModelTerm& t : model) {
    if (t.known || !positive(t.term.kind) || t.value > 0) continue;
    double sum = 0, count = 0;
    for (const ModelTerm& like : model)
      if (like.term.kind == t.term.kind && like.value > 0) sum += like.value, ++count;
    if (count > 0) t.value = sum / count;
  }
}

}  // namespace

void start_values(const System& system, const std::vector<Prepared>& records, Model& model) {
  std::vector<size_t> unknown;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known) unknown.push_back(i);
  if (unknown.empty()) return;
  const Index p = static_cast<Index>(unknown.size());
  Moments m{Mat::Zero(p, p), Vec::Zero(p)};
  for (const Prepared& r : records) add_moments(system, r, model, unknown, any_mass(model, unknown), m);
  const Vec values = solved(m.gram, m.right);
  // what must be positive and is not starts from a tenth of what its column could carry alone
  for (Index i = 0; i < p; ++i) {
    ModelTerm& t = model[unknown[static_cast<size_t>(i)]];
    double value = values[i];
    if (positive(t.term.kind) && value <= 0) value = 0.1 * std::abs(m.right[i]) / std::max(1e-300, m.gram(i, i));
    if ((t.term.kind == Kind::kViscous || t.term.kind == Kind::kCoulomb) && value < 0) value = 0;
    t.value = value;
  }
  fill_from_likes(model);
}

}  // namespace diagnosis::runs
