// The normal equations of a fit against least squares over whitened rows, written out densely.
#include "host_sim/diagnosis/rows/projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <random>

#include "draw.hpp"
#include "host_sim/diagnosis/search/candidates.hpp"

namespace diagnosis {
namespace {

constexpr Eigen::Index kBins = 40, kDofs = 3;

struct Problem {
  std::mt19937_64 dice{17};
  std::normal_distribution<double> normal;
  std::vector<Eigen::MatrixXcd> covariance;
  std::vector<FittedColumn> columns;
  std::vector<Balance> target;

  Spectrum spectrum() {
    Spectrum s(kBins);
    for (Complex& v : s) v = {normal(dice), normal(dice)};
    return s;
  }
  Problem() {
    for (Eigen::Index i = 0; i < kBins; ++i) {
      Eigen::MatrixXcd a(kDofs, kDofs);
      for (Eigen::Index j = 0; j < kDofs; ++j)
        for (Eigen::Index k = 0; k < kDofs; ++k) a(j, k) = {normal(dice), normal(dice)};
      covariance.push_back(a * a.adjoint() + 0.1 * Eigen::MatrixXcd::Identity(kDofs, kDofs));
    }
    for (Place place : {Place{0, -1}, Place{0, 1}, Place{1, 2}, Place{2, -1}, Place{0, 1}})
      columns.push_back({place, std::make_shared<Spectra>(1, spectrum())});
    target.emplace_back(kBins, kDofs);
    for (Eigen::Index j = 0; j < kDofs; ++j) target[0].col(j) = spectrum();
  }
  std::shared_ptr<const Weights> weights() const {
    Triangle entries;
    for (Eigen::Index j = 0; j < kDofs; ++j)
      for (Eigen::Index k = 0; k <= j; ++k) {
        entries.push_back(Spectrum(kBins));
        for (Eigen::Index i = 0; i < kBins; ++i) entries.back()[i] = covariance[static_cast<size_t>(i)](j, k);
      }
    return std::make_shared<Weights>(1, Information(kDofs, entries));
  }
  Projection fit() const { return Projection(weights(), columns, target); }

  // rows of all bins, whitened by the inverse of Cholesky's factor: real parts, then imaginary parts
  Eigen::VectorXd whitened(const Balance& b) const {
    Eigen::VectorXd rows(2 * kBins * kDofs);
    for (Eigen::Index i = 0; i < kBins; ++i) {
      const Eigen::MatrixXcd full = covariance[static_cast<size_t>(i)];
      const Eigen::VectorXcd force = b.row(i).transpose();
      const Eigen::VectorXcd white = full.llt().matrixL().solve(force);
      rows.segment(2 * i * kDofs, kDofs) = white.real(), rows.segment((2 * i + 1) * kDofs, kDofs) = white.imag();
    }
    return rows;
  }
  Eigen::VectorXd whitened(const FittedColumn& c) const {
    Balance b = Balance::Zero(kBins, kDofs);
    if (c.place.plus >= 0) b.col(c.place.plus) = (*c.spectra)[0];
    if (c.place.minus >= 0) b.col(c.place.minus) = -(*c.spectra)[0];
    return whitened(b);
  }
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd a(2 * kBins * kDofs, static_cast<Eigen::Index>(columns.size()));
    for (size_t i = 0; i < columns.size(); ++i) a.col(static_cast<Eigen::Index>(i)) = whitened(columns[i]);
    return a;
  }
};

// Two masses, a backlash hidden, and what could be beside the rig as given.
struct OnePlant {
  static hidden::Draw drawn() {
    hidden::Settings settings;
    settings.seconds = 4, settings.dofs = 2, settings.kind = "backlash";
    return hidden::make_draw(31, settings);
  }
  static std::vector<FusedRecord> fused(const hidden::Draw& draw) {
    std::vector<FusedRecord> records{read_record(draw.rig, draw.record, 0.098)};
    estimate_noise(records[0]);
    fuse(records[0]);
    return records;
  }
  hidden::Draw draw = drawn();
  System system = make_system(draw.rig);
  std::vector<FusedRecord> records = fused(draw);
  Rows rows{system, records};
  CandidateBank bank{rows};
  std::vector<ActiveTerm> model = base_model(rows);
  Fit fit = settle(rows, model, 2);
  std::vector<Candidate> candidates = bank.beside(model);
};

double squared_residual(const Eigen::MatrixXd& a, const Eigen::VectorXd& y) {
  return (y - a * a.householderQr().solve(y)).squaredNorm();
}

TEST(Projection, ValuesAndResidualAreThoseOfWhitenedRows) {
  const Problem p;
  const Projection fit = p.fit();
  const Eigen::MatrixXd a = p.dense();
  const Eigen::VectorXd y = p.whitened(p.target[0]), value = a.householderQr().solve(y);
  const Eigen::MatrixXd covariance = (a.transpose() * a).inverse();
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    EXPECT_NEAR(fit.value(i), value[i], 1e-9);
    EXPECT_NEAR(fit.std(i), std::sqrt(covariance(i, i)), 1e-9);
  }
  EXPECT_NEAR(fit.chi2(), squared_residual(a, y), 1e-8);
}

TEST(Projection, ProductsTellWhatAFurtherColumnGains) {
  Problem p;
  const FittedColumn further{{1, 2}, std::make_shared<Spectra>(1, p.spectrum())};
  const Projection fit = p.fit();
  const Projection::Products products = fit.products(further.place, {&*further.spectra, &*p.columns[2].spectra});
  const double free = products.square[0] - products.fitted.col(0).squaredNorm();
  const double gain = products.residual[0] * products.residual[0] / free;
  Eigen::MatrixXd more = p.dense();
  more.conservativeResize(Eigen::NoChange, 6);
  more.col(5) = p.whitened(further);
  const Eigen::VectorXd y = p.whitened(p.target[0]);
  EXPECT_NEAR(gain, squared_residual(p.dense(), y) - squared_residual(more, y), 1e-8);
  EXPECT_NEAR(products.square[0], more.col(5).squaredNorm(), 1e-8);
  // a column that is fitted already has nothing left to gain
  EXPECT_NEAR(products.square[1], products.fitted.col(1).squaredNorm(), 1e-8);
  EXPECT_NEAR(products.residual[1], 0, 1e-8);
  // and the value of a fitted column answers as a fit with both shows
  const Eigen::VectorXd value = more.householderQr().solve(y);
  EXPECT_NEAR(fit.value(1) - value[5] * fit.answer(1, products.fitted.col(0)), value[1], 1e-9);
}

TEST(Projection, DisturbancesOfEveryDofExplainWhatAFitWithThemShows) {
  Problem p;
  const auto disturbance = [&] {
    Balance b(kBins, kDofs);
    for (Eigen::Index j = 0; j < kDofs; ++j) b.col(j) = p.spectrum();
    return std::vector<Balance>{b};
  };
  const std::vector<std::vector<Balance>> group{disturbance(), disturbance()};
  const Projection::Explained explained = p.fit().explained(group);
  Eigen::MatrixXd more = p.dense();
  more.conservativeResize(Eigen::NoChange, 7);
  more.col(5) = p.whitened(group[0][0]), more.col(6) = p.whitened(group[1][0]);
  const Eigen::VectorXd y = p.whitened(p.target[0]), value = more.householderQr().solve(y);
  EXPECT_NEAR(explained.chi2, squared_residual(p.dense(), y) - squared_residual(more, y), 1e-8);
  EXPECT_NEAR(explained.value[0], value[5], 1e-9);
  EXPECT_NEAR(explained.value[1], value[6], 1e-9);
  const Eigen::VectorXd free = more.col(5) - p.dense() * p.dense().householderQr().solve(more.col(5));
  EXPECT_NEAR(explained.std[0], 1 / free.norm(), 1e-9);
  // one that the fitted columns can make says nothing
  Balance made = Balance::Zero(kBins, kDofs);
  act(made, p.columns[2].place, (*p.columns[2].spectra)[0], 3);
  EXPECT_EQ(p.fit().explained({{made}}).chi2, 0);
}

TEST(Projection, AColumnThatOthersMakeUpIsLeftOut) {
  Problem p;
  const Projection fit = p.fit();
  p.columns.push_back(
      {p.columns[1].place, std::make_shared<Spectra>(1, 2 * (*p.columns[1].spectra)[0] - (*p.columns[4].spectra)[0])});
  const Projection again = p.fit();
  EXPECT_NEAR(again.value(5), 0, 1e-9);
  EXPECT_NEAR(again.chi2(), fit.chi2(), 1e-8);
}

TEST(Projection, AWeightTellsTheDeterminantOfItsCovariance) {
  const Problem p;
  double logarithm = 0;
  for (const Eigen::MatrixXcd& one : p.covariance) logarithm += std::log(one.determinant().real());
  EXPECT_NEAR(p.weights()->front().log_determinant(), logarithm, 1e-8);
}

// A coefficient that the rows know with s and that is in doubt by 3 s must be (s^2 + 9 s^2) / s^2 times as significant.
TEST(Projection, ADoubtRaisesWhatIsNeeded) {
  Candidate c;
  c.threshold = 17;
  EXPECT_EQ(c.needed(0.2), 17);
  c.doubt = 0.6;
  EXPECT_NEAR(c.needed(0.2), 170, 1e-9);
}

// Every candidate of the vocabulary, among them those that take the place of a spring or of friction.
TEST(Projection, EveryPredictedGainIsWhatARefitShows) {
  const OnePlant plant;
  const std::vector<Candidate>& candidates = plant.candidates;
  const std::vector<ActiveTerm>& model = plant.model;
  const Fit& fit = plant.fit;
  const std::vector<Gain> gains = gains_of(plant.rows, model, fit, candidates);
  int hosted = 0;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].coefficient_sign != 0 && gains[i].chi2 == 0) continue;  // against its physical sign
    std::vector<ActiveTerm> more = joined(model, candidates[i], gains[i]);
    const double refit = fit.chi2 - fit_model(plant.rows, more).chi2;
    EXPECT_NEAR(gains[i].chi2, refit, 1e-6 * fit.chi2) << word_of(candidates[i].term().kind);
    hosted += candidates[i].host >= 0 && !candidates[i].fixed;
  }
  EXPECT_GT(hosted, 0);
}

}  // namespace
}  // namespace diagnosis
