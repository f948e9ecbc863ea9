#include "mode_scan.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr double kBelow = 0.7;        // times the lowest frequency, and
constexpr double kAbove = 1.5;        // times the highest one: where a hidden mode shows in the motion
constexpr double kFinestStep = 1.03;  // of its frequency: half the width of a resonance that is damped by 3 %
constexpr double kRatios[] = {0.005, 0.02, 0.06};  // of its damping
constexpr double kLeastMass = 1e-4;                // of the mass that carries it

// Real numbers beside complex columns; what they leave, squared.
double solved(const Eigen::MatrixXcd& columns, const Eigen::VectorXcd& given, Vec& numbers) {
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

Eigen::VectorXcd mode_column(const SpectralBalance& b, const HiddenMode& mode) {
  Eigen::VectorXcd column = Eigen::VectorXcd::Zero(b.given.size());
  for (Index i = 0; i < column.size(); ++i) {
    if (b.dof[static_cast<size_t>(i)] != mode.dof) continue;
    const double r = b.hertz[i] / mode.resonance_Hz;
    const Complex damped(0, 2 * mode.damping_ratio * r);
    column[i] = b.mode_acceleration[i] * (1.0 + damped) / (1.0 - r * r + damped);
  }
  return column;
}

bool possible(const SpectralBalance& b, const Model& model, const Vec& numbers) {
  for (size_t i = 0; i < b.numbers.size(); ++i) {
    const Kind kind = model[b.numbers[i]].term.kind;
    if ((kind == Kind::kMass || kind == Kind::kStiffness) && numbers[static_cast<Index>(i)] <= 0) return false;
  }
  return true;
}

bool possible(const SpectralBalance& b, const Model& model, const HiddenMode& mode) {
  if (!possible(b, model, mode.numbers)) return false;
  double carries = 0;
  for (const ModelTerm& t : with_numbers(b, mode.numbers, model))
    if (t.term.kind == Kind::kMass && t.term.dof == mode.dof) carries = t.value;
  return mode.mass_kg > kLeastMass * carries;
}

}  // namespace

std::optional<Model> balanced_numbers(const System& system, const std::vector<Prepared>& records, const Model& model) {
  const SpectralBalance b = spectral_balance(system, records, model);
  if (b.numbers.empty() || b.given.size() <= static_cast<Index>(b.numbers.size())) return {};
  Vec numbers;
  solved(b.columns, b.given, numbers);
  if (!numbers.allFinite() || !possible(b, model, numbers)) return {};
  return with_numbers(b, numbers, model);
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
