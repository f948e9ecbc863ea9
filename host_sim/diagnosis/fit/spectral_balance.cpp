#include "spectral_balance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr Index kSegments = 8;        // of a record, and as many half way between them: for a coherent mean
constexpr double kDriven = 1e-4;      // of the drive's highest power: less is its noise
constexpr double kBelow = 0.7;        // times the lowest frequency, and
constexpr double kAbove = 1.5;        // times the highest one: where a hidden mode shows in the motion
constexpr double kFinestStep = 1.03;  // of its frequency: half the width of a resonance that is damped by 3 %
constexpr double kRatios[] = {0.005, 0.02, 0.06};  // of its damping
constexpr double kLeastMass = 1e-4;                // of the mass that carries it

using Complexes = Eigen::VectorXcd;

// Of one segment: what drives the rig, and every DOF's acceleration.
struct SegmentSpectra {
  std::vector<Spectrum> force;  // per DOF; empty: none
  std::vector<Spectrum> acceleration;
};

// The steepest of a DOF's readings: what is divided by the frequency hides no noise.
const MotionTrace* steepest(const Prepared& record, int dof) {
  for (int quantity : {2, 1, 0})
    if (const MotionTrace* trace = trace_of(record, dof, quantity)) return trace;
  return nullptr;
}

class Segments {
 public:
  Segments(const Prepared& record, size_t length)
      : record_(record), fourier_(length), step_s_(record.step_s), hann_(static_cast<Index>(length)) {
    for (Index k = 0; k < hann_.size(); ++k)
      hann_[k] = 0.5 - 0.5 * std::cos(kTwoPi * (static_cast<double>(k) + 0.5) / static_cast<double>(length));
  }
  SegmentSpectra at(Index from) const {
    SegmentSpectra s;
    for (size_t d = 0; d < record_.force.size(); ++d) {
      s.force.push_back(record_.force[d].size() ? of(record_.force[d], from) : Spectrum());
      const MotionTrace* trace = steepest(record_, static_cast<int>(d));
      s.acceleration.push_back(trace ? of(trace->y, from) : Spectrum::Zero(fourier_.bins()));
      for (Index i = 1; trace && i < s.acceleration[d].size(); ++i)
        for (int q = trace->quantity; q < 2; ++q) s.acceleration[d][i] *= Complex(0, omega(i));
    }
    return s;
  }
  double omega(Index bin) const {
    return kTwoPi * static_cast<double>(bin) / (static_cast<double>(hann_.size()) * step_s_);
  }
  Index bins() const { return fourier_.bins(); }

 private:
  Spectrum of(const Vec& y, Index from) const {
    const Vec part = y.segment(from, hann_.size());
    return fourier_.forward(hann_.cwiseProduct((part.array() - part.mean()).matrix()));
  }
  const Prepared& record_;
  Fourier fourier_;
  double step_s_;
  Vec hann_;
};

// Power of a drive, and what goes with it of every force and acceleration: sums over segments.
struct Cross {
  Vec power;
  std::vector<Complexes> force, acceleration;  // per DOF
};

void add(const SegmentSpectra& s, size_t drive, Cross& sum) {
  const Spectrum along = s.force[drive].conjugate();
  sum.power += s.force[drive].cwiseAbs2();
  for (size_t d = 0; d < s.acceleration.size(); ++d) {
    if (s.force[d].size()) sum.force[d] += along.cwiseProduct(s.force[d]);
    sum.acceleration[d] += along.cwiseProduct(s.acceleration[d]);
  }
}

bool linear_number(const ModelTerm& t) {
  const Kind k = t.term.kind;
  return k == Kind::kMass || k == Kind::kMassError || k == Kind::kStiffness || k == Kind::kStiffnessError ||
         k == Kind::kViscous || k == Kind::kMissingViscous;
}

// What a term of one unit makes of a DOF's balance, from all DOFs' accelerations in a bin.
Complex column_of(const System& system, const Term& t, int dof, double omega,
                  const std::vector<Complex>& acceleration) {
  if (t.link < 0) return t.dof == dof ? acceleration[static_cast<size_t>(dof)] : Complex(0);
  const rig_file::Link& l = system.links[static_cast<size_t>(t.link)];
  if (l.a != dof + 1 && l.b != dof + 1) return 0;
  const auto of_end = [&](int end) { return end >= 1 ? acceleration[static_cast<size_t>(end - 1)] : Complex(0); };
  const Complex across = of_end(l.a) - of_end(l.b), sign = l.a == dof + 1 ? 1 : -1;
  const bool damper = t.kind == Kind::kViscous || t.kind == Kind::kMissingViscous;
  return sign * (damper ? across / Complex(0, omega) : -across / (omega * omega));
}

struct Row {
  int dof;
  double hertz;
  std::vector<Complex> columns;
  Complex given, mode;
};

void add_rows(const System& system, const Model& model, const std::vector<size_t>& numbers, const Cross& cross,
              const Segments& segments, double low_Hz, double high_Hz, std::vector<Row>& rows) {
  const double driven = kDriven * cross.power.tail(cross.power.size() - 1).maxCoeff();
  for (Index i = 1; i < segments.bins(); ++i) {
    const double omega = segments.omega(i), hertz = omega / kTwoPi, root = std::sqrt(cross.power[i]);
    if (hertz < low_Hz || hertz > high_Hz || !(cross.power[i] > driven)) continue;
    std::vector<Complex> acceleration;
    for (const Complexes& a : cross.acceleration) acceleration.push_back(a[i] / root);
    for (size_t d = 0; d < cross.acceleration.size(); ++d) {
      Row row{static_cast<int>(d),
              hertz,
              {},
              cross.force[d].size() ? cross.force[d][i] / root : Complex(0),
              acceleration[d]};
      for (size_t n : numbers) row.columns.push_back(column_of(system, model[n].term, row.dof, omega, acceleration));
      for (const ModelTerm& t : model)
        if (t.known && linear_number(t)) row.given -= t.value * column_of(system, t.term, row.dof, omega, acceleration);
      rows.push_back(row);
    }
  }
}

SpectralBalance stacked(const std::vector<Row>& rows, const std::vector<size_t>& numbers) {
  SpectralBalance b;
  const Index n = static_cast<Index>(rows.size());
  b.numbers = numbers, b.hertz.resize(n), b.given.resize(n), b.mode_acceleration.resize(n);
  b.columns.resize(n, static_cast<Index>(numbers.size()));
  for (Index i = 0; i < n; ++i) {
    const Row& row = rows[static_cast<size_t>(i)];
    b.dof.push_back(row.dof), b.hertz[i] = row.hertz, b.given[i] = row.given, b.mode_acceleration[i] = row.mode;
    for (Index j = 0; j < b.columns.cols(); ++j) b.columns(i, j) = row.columns[static_cast<size_t>(j)];
  }
  return b;
}

// Real numbers beside complex columns; what they leave, squared.
double solved(const Eigen::MatrixXcd& columns, const Complexes& given, Vec& numbers) {
  const Index n = columns.rows();
  Mat a(2 * n, columns.cols());
  Vec b(2 * n);
  a << columns.real(), columns.imag();
  b << given.real(), given.imag();
  if (a.cols() == 0) return b.squaredNorm();
  const Vec scale = a.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Mat unit = a * scale.asDiagonal();
  numbers = scale.asDiagonal() * (unit.transpose() * unit).ldlt().solve(unit.transpose() * b);
  return (b - a * numbers).squaredNorm();
}

Complexes mode_column(const SpectralBalance& b, const HiddenMode& mode) {
  Complexes column = Complexes::Zero(b.given.size());
  for (Index i = 0; i < column.size(); ++i) {
    if (b.dof[static_cast<size_t>(i)] != mode.dof) continue;
    const double r = b.hertz[i] / mode.resonance_Hz;
    const Complex damped(0, 2 * mode.damping_ratio * r);
    column[i] = b.mode_acceleration[i] * (1.0 + damped) / (1.0 - r * r + damped);
  }
  return column;
}

bool possible(const SpectralBalance& b, const Model& model, const HiddenMode& mode) {
  double carries = 0;
  for (const ModelTerm& t : model)
    if (t.term.kind == Kind::kMass && t.term.dof == mode.dof) carries = t.value;
  for (size_t i = 0; i < b.numbers.size(); ++i) {
    const ModelTerm& t = model[b.numbers[i]];
    const double value = mode.numbers[static_cast<Index>(i)];
    if ((t.term.kind == Kind::kMass || t.term.kind == Kind::kStiffness) && value <= 0) return false;
    if (t.term.kind == Kind::kMass && t.term.dof == mode.dof) carries = value;
  }
  return mode.mass_kg > kLeastMass * carries;
}

}  // namespace

SpectralBalance spectral_balance(const System& system, const std::vector<Prepared>& records, const Model& model) {
  std::vector<size_t> numbers;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known && linear_number(model[i])) numbers.push_back(i);
  std::vector<Row> rows;
  for (const Prepared& p : records) {
    const Index length = static_cast<Index>(fast_length(static_cast<size_t>(2 * p.samples / (kSegments + 1))));
    if (p.base.given() || length < kLeast) return {};
    const Segments segments(p, static_cast<size_t>(length));
    for (size_t drive = 0; drive < p.force.size(); ++drive) {
      if (p.force[drive].size() == 0 || p.force[drive].cwiseAbs().maxCoeff() <= 0) continue;
      const Complexes none = Complexes::Zero(segments.bins());
      Cross cross{Vec::Zero(segments.bins()), {}, std::vector<Complexes>(p.force.size(), none)};
      for (const Vec& f : p.force) cross.force.push_back(f.size() ? none : Complexes());
      for (Index from = 0; from + length <= p.samples; from += length / 2) add(segments.at(from), drive, cross);
      add_rows(system, model, numbers, cross, segments, 0.5 / p.period_s, p.top_Hz, rows);
    }
  }
  return stacked(rows, numbers);
}

std::optional<HiddenMode> hidden_mode(const SpectralBalance& b, const Model& model) {
  if (b.given.size() <= 2 * static_cast<Index>(b.numbers.size())) return {};
  Vec alone;
  const double without = solved(b.columns, b.given, alone);
  std::optional<HiddenMode> best;
  Eigen::MatrixXcd columns(b.columns.rows(), b.columns.cols() + 1);
  columns.leftCols(b.columns.cols()) = b.columns;
  for (const ModelTerm& t : model) {
    if (t.term.kind != Kind::kMass) continue;
    for (double hertz = kBelow * b.hertz.minCoeff(); hertz < kAbove * b.hertz.maxCoeff(); hertz *= kFinestStep)
      for (double ratio : kRatios) {
        HiddenMode mode{t.term.dof, hertz, ratio, 0, {}, 1};
        columns.rightCols(1) = mode_column(b, mode);
        Vec numbers;
        mode.left = solved(columns, b.given, numbers) / std::max(1e-300, without);
        mode.mass_kg = numbers[numbers.size() - 1], mode.numbers = numbers.head(numbers.size() - 1);
        if ((!best || mode.left < best->left) && possible(b, model, mode)) best = mode;
      }
  }
  return best;
}

}  // namespace diagnosis::runs
