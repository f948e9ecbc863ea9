#include "spectral_balance.hpp"

#include <cmath>

#include "cross_spectra.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kDriven = 1e-4;  // of the drive's highest power: less is its noise
constexpr double kGoesWith =
    0.5;  // of a DOF's power, with its base: an accelerometer drifts, and nothing moves with it

bool linear_number(const ModelTerm& t) {
  const Kind k = t.term.kind;
  return k == Kind::kMass || k == Kind::kMassError || k == Kind::kStiffness || k == Kind::kStiffnessError ||
         k == Kind::kViscous || k == Kind::kMissingViscous;
}

// What a term of one unit makes of a DOF's balance, from all DOFs' accelerations in a bin, and a moving base's behind them.
Complex column_of(const System& system, const Term& t, int dof, double omega,
                  const std::vector<Complex>& acceleration) {
  if (t.link < 0) return t.dof == dof ? acceleration[static_cast<size_t>(dof)] : Complex(0);
  const rig_file::Link& l = system.links[static_cast<size_t>(t.link)];
  if (l.a != dof + 1 && l.b != dof + 1) return 0;
  const auto of_end = [&](int end) {
    if (end >= 1) return acceleration[static_cast<size_t>(end - 1)];
    return end == rig_file::kBase && acceleration.size() > system.dofs() ? acceleration.back() : Complex(0);
  };
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

void add_rows(const System& system, const Model& model, const std::vector<size_t>& numbers, const CrossSpectra& cross,
              double low_Hz, double high_Hz, std::vector<Row>& rows) {
  const double driven = kDriven * cross.power.tail(cross.power.size() - 1).maxCoeff();
  for (Index i = 1; i < cross.hertz.size(); ++i) {
    const double hertz = cross.hertz[i], omega = kTwoPi * hertz, root = std::sqrt(cross.power[i]);
    if (hertz < low_Hz || hertz > high_Hz || !(cross.power[i] > driven)) continue;
    if (cross.of_base && !(cross.coherence(i) > kGoesWith)) continue;
    std::vector<Complex> acceleration;
    for (const Eigen::VectorXcd& a : cross.acceleration) acceleration.push_back(a[i] / root);
    for (size_t d = 0; d < cross.force.size(); ++d) {
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

}  // namespace

SpectralBalance spectral_balance(const System& system, const std::vector<Prepared>& records, const Model& model) {
  std::vector<size_t> numbers;
  for (size_t i = 0; i < model.size(); ++i)
    if (!model[i].known && linear_number(model[i])) numbers.push_back(i);
  std::vector<Row> rows;
  for (const Prepared& p : records) {
    if (p.base.ridden) return {};
    for (const CrossSpectra& cross : cross_spectra(p))
      add_rows(system, model, numbers, cross, 0.5 / p.period_s, p.top_Hz, rows);
  }
  return stacked(rows, numbers);
}

Model with_numbers(const SpectralBalance& b, const Vec& numbers, Model model) {
  for (size_t i = 0; i < b.numbers.size(); ++i) model[b.numbers[i]].value = numbers[static_cast<Index>(i)];
  return model;
}

}  // namespace diagnosis::runs
