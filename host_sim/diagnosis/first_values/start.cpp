// First values by least squares, or by instruments where noise would shrink them.
#include "start.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "balance.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kMostRows = 20000;  // of a DOF: first values need no more

// Normal equations of the unknown numbers, each DOF's balance weighted by its own size.
struct Moments {
  Mat gram;
  Vec right;
};

// What noise makes of a guess reaches over two smoothings on either side.
Index beyond_noise_of(const Prepared& r) { return 4 * r.smooth_half + 1; }

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

// lag: of the instruments, in rows; 0: the columns themselves.
void add_moments(const DofBalance& d, const std::vector<Vec>& forces, Index lag, Moments& m) {
  const Index count = d.given.size() - 2 * lag;
  const Mat a = d.rows.middleRows(lag, count);
  const Vec b = d.given.segment(lag, count);
  // weighted by the size of the forces on this DOF
  double size = b.squaredNorm() + 1e-300;
  if (b.squaredNorm() <= 0) size = std::max(1e-300, a.colwise().squaredNorm().maxCoeff());
  Mat told = a;
  if (lag > 0) {
    const Mat z = instruments_of(d.rows, forces, lag);
    told = z * solved(z.transpose() * z, z.transpose() * a);
  }
  const Mat gram = told.transpose() * told / size;
  const Vec right = told.transpose() * b / size;
  for (size_t i = 0; i < d.acting.size(); ++i) {
    m.right[d.acting[i]] += right[static_cast<Index>(i)];
    for (size_t j = 0; j < d.acting.size(); ++j)
      m.gram(d.acting[i], d.acting[j]) += gram(static_cast<Index>(i), static_cast<Index>(j));
  }
}

void add_moments(const System& system, const Prepared& r, const Model& model, const std::vector<size_t>& unknown,
                 bool instruments, Moments& m) {
  const Index stride = std::max<Index>(1, r.samples / kMostRows);
  const Index count = (r.samples - 2 * kFirstBalanced + stride - 1) / stride;
  const Index lag = instruments ? (beyond_noise_of(r) + stride - 1) / stride : 0;
  std::vector<Vec> forces;
  for (const Vec& f : r.force)
    if (f.size()) forces.push_back(Vec::Map(f.data() + kFirstBalanced, count, Eigen::InnerStride<>(stride)));
  for (const DofBalance& d : balances_of(system, r, model, unknown, stride, count))
    if (!d.acting.empty() && count > 2 * lag) add_moments(d, forces, lag, m);
}

bool grows(Kind kind) { return kind == Kind::kQuadraticDamping || kind == Kind::kCubicDamping; }

// An unknown damper of a link that has another one which grows faster than its rate, and the other itself.
bool trades(const Model& model, const std::vector<size_t>& unknown, size_t term) {
  const Term& own = model[term].term;
  if (own.link < 0 || !(grows(own.kind) || own.kind == Kind::kViscous || own.kind == Kind::kCoulomb)) return false;
  return std::any_of(unknown.begin(), unknown.end(),
                     [&](size_t i) { return grows(model[i].term.kind) && model[i].term.link == own.link; });
}

// A law that drives the more the faster it goes ends nowhere in a run. Of dampers that trade with one the least that noise gives less than
// nothing starts from nought, and the others are solved for without it: one of them has what it lacks.
Vec damping_solved(const Moments& m, const std::vector<size_t>& unknown, const Model& model) {
  Moments left = m;
  const Index p = m.right.size();
  for (Index round = 0; round <= p; ++round) {
    const Vec values = solved(left.gram, left.right);
    Index worst = -1;
    double least = 0;
    for (Index i = 0; i < p; ++i) {
      const double size = values[i] * std::sqrt(std::max(0.0, m.gram(i, i)));  // of its force
      if (size < least && trades(model, unknown, unknown[static_cast<size_t>(i)])) worst = i, least = size;
    }
    if (worst < 0) return values;
    left.gram.row(worst).setZero(), left.gram.col(worst).setZero(), left.right[worst] = 0;
  }
  return Vec::Zero(p);
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
  const Vec values = damping_solved(m, unknown, model);
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
