#include "host_sim/records/derived/of_rounding.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host_sim/records/steps/value_step.hpp"

namespace host_sim {
namespace {

using Values = std::vector<double>;
using Index = Eigen::Index;

constexpr size_t kReach = 10;          // rows to either side: a smoothing over 20 of them
constexpr size_t kOwnReach = 2;        // and of the column itself: a low-pass of second order, there and back
constexpr double kUsual = 0.9;         // of the rows
constexpr size_t kRowsPerNumber = 10;  // for each number that is fitted
constexpr size_t kMostRows = 20000;    // evenly spread
constexpr double kOtherwise = 0.02;    // of the rows, where what is read around all others comes again a cycle later
constexpr size_t kMostCycle = 10000;   // rows

struct Fit {
  double mean_square = 0;  // of what is left, of the rows that are left off least
  double taps_square = 0;  // sum of the squared taps of x, per s^2
};

// The rows of a stretch that moves: at rest everything is alike.
std::vector<size_t> moving_rows(const Values& slopes) {
  std::vector<size_t> rows;
  size_t still = 0;  // slopes of nought up to here
  for (size_t i = 0; i < slopes.size(); ++i) {
    still = slopes[i] == 0.0 ? still + 1 : 0;
    if (i + 1 >= 2 * kReach && still < 2 * kReach) rows.push_back(i + 1 - kReach);
  }
  if (rows.size() <= kMostRows) return rows;
  std::vector<size_t> few(kMostRows);
  for (size_t i = 0; i < kMostRows; ++i) few[i] = rows[i * rows.size() / kMostRows];
  return few;
}

// Of each row what is read around it, as a number: rows with the same readings have the same number.
std::vector<uint64_t> patterns(const Values& x, double step) {
  constexpr uint64_t kFactor = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
  std::vector<uint64_t> all(x.size(), 0);
  for (size_t i = kReach; i + kReach < x.size(); ++i)
    for (size_t k = i - kReach; k <= i + kReach; ++k)
      all[i] = (all[i] ^ static_cast<uint64_t>(std::llround(x[k] / step))) * kFactor;
  return all;
}

// Whether x goes through the same readings in every cycle: a sine without noise that is locked to the sampling. All that has its period is
// a function of where in the cycle a row is, and so are the steps: one that follows from the other proves nothing.
bool repeats_itself(const Values& x, double step, const std::vector<size_t>& rows) {
  const std::vector<uint64_t> pattern = patterns(x, step);
  const auto allowed = static_cast<size_t>(kOtherwise * static_cast<double>(rows.size()));
  for (size_t cycle = 2; cycle <= std::min(kMostCycle, x.size() / 4); ++cycle) {
    size_t otherwise = 0;
    for (size_t r = 0; r < rows.size() && otherwise <= allowed; ++r)
      if (rows[r] + cycle + kReach < x.size()) otherwise += pattern[rows[r]] != pattern[rows[r] + cycle];
    if (otherwise <= allowed) return true;
  }
  return false;
}

Eigen::MatrixXd regressors(const Values& y, const Values& slopes, const std::vector<size_t>& rows, bool own) {
  Eigen::MatrixXd a(static_cast<Index>(rows.size()), static_cast<Index>(2 * kReach + (own ? 2 * kOwnReach : 0)));
  for (size_t r = 0; r < rows.size(); ++r) {
    Index c = 0;
    for (size_t k = 0; k < 2 * kReach; ++k) a(static_cast<Index>(r), c++) = slopes[rows[r] + k - kReach];
    for (size_t j = 1; own && j <= kOwnReach; ++j)
      a(static_cast<Index>(r), c++) = y[rows[r] - j], a(static_cast<Index>(r), c++) = y[rows[r] + j];
  }
  return a;
}

// The least square among the rows that are off most, of which kUsual are left.
double limit_of(const Eigen::VectorXd& off) {
  std::vector<double> size(off.data(), off.data() + off.size());
  for (double& value : size) value = std::abs(value);
  const auto at = size.begin() + static_cast<std::ptrdiff_t>(kUsual * static_cast<double>(size.size() - 1));
  std::nth_element(size.begin(), at, size.end());
  return *at;
}

// Twice: the rows that are off most the first time have no say the second.
Fit fit_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& y, double step_s) {
  Eigen::VectorXd c = a.colPivHouseholderQr().solve(y), off = y - a * c;
  const double limit = limit_of(off);
  Eigen::VectorXd weight = (off.array().abs() <= limit).cast<double>();
  c = (weight.asDiagonal() * a).colPivHouseholderQr().solve(weight.cwiseProduct(y).eval());
  off = y - a * c;
  const double last = limit_of(off);
  Fit fit;
  double count = 0;
  for (const double value : off)
    if (std::abs(value) <= last) fit.mean_square += value * value, ++count;
  fit.mean_square /= std::max(1.0, count);
  for (size_t k = 0; k <= 2 * kReach; ++k) {  // x of a row ends the one slope and begins the next
    const double ends = k > 0 ? c[static_cast<Index>(k - 1)] : 0,
                 begins = k < 2 * kReach ? c[static_cast<Index>(k)] : 0;
    fit.taps_square += (ends - begins) * (ends - begins) / (step_s * step_s);
  }
  return fit;
}

}  // namespace

bool follows_rounding(const Channel& column, const Channel& of, const Values& t_s) {
  const double step = value_step(of.values);
  if (!(step > 0.0) || t_s.size() < 4 * kReach) return false;
  const Values &x = of.values, &y = column.values;
  Values slopes(x.size() - 1);
  for (size_t i = 0; i < slopes.size(); ++i) slopes[i] = (x[i + 1] - x[i]) / (t_s[i + 1] - t_s[i]);
  const std::vector<size_t> rows = moving_rows(slopes);
  const double step_s = (t_s.back() - t_s.front()) / static_cast<double>(t_s.size() - 1);
  Eigen::VectorXd wanted(static_cast<Index>(rows.size()));
  for (size_t r = 0; r < rows.size(); ++r) wanted[static_cast<Index>(r)] = y[rows[r]];
  if (!wanted.allFinite()) return false;
  for (const bool own : {false, true}) {
    const Eigen::MatrixXd a = regressors(y, slopes, rows, own);
    if (rows.size() < kRowsPerNumber * static_cast<size_t>(a.cols()) || !a.allFinite()) return false;
    const Fit fit = fit_of(a, wanted, step_s);
    if (fit.mean_square < kOwn * kOwn * fit.taps_square * step * step / 12) return !repeats_itself(x, step, rows);
  }
  return false;
}

}  // namespace host_sim
