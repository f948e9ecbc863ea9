#include "host_sim/programs/shared/swing.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kPeriods = 3;  // of a stretch
constexpr size_t kMostStretches = 16, kLeastStretches = 4;
constexpr double kAmplitudes = 2;  // square of the largest amplitude over that of the smallest
// Of the largest square: at 3 % of the amplitude friction holds, and what is left is noise.
constexpr double kQuiet = 1e-3;

constexpr size_t kSpeedParts =
    8;  // of a period, from where and to where a speed is taken: single wrong values and noise hardly move it

size_t periods_of(const std::vector<double>& y, size_t from, size_t to, double mean) {
  size_t rises = 0;
  for (size_t k = from + 1; k < to; ++k) rises += y[k - 1] < mean && y[k] >= mean;
  return rises;
}

// Samples in an eighth of a period about the plain mean; one where noise crosses it all the time.
size_t eighth_of_a_period(const std::vector<double>& y, size_t from, size_t to) {
  double sum = 0;
  for (size_t k = from; k < to; ++k) sum += y[k];
  const size_t periods = periods_of(y, from, to, sum / static_cast<double>(to - from));
  return periods == 0 ? 1 : std::max<size_t>(1, (to - from) / (kSpeedParts * periods));
}

size_t clear_swings(const std::vector<double>& y, size_t to, double mean, double rms) {
  size_t count = 0;
  bool below = false;
  for (size_t k = 0; k < to; ++k) {
    if (y[k] - mean < -0.5 * rms) below = true;
    if (below && y[k] - mean > 0.5 * rms) below = false, ++count;
  }
  return count;
}

struct Stretch {
  double centre = 0, square = 0;  // of the amplitude
};

void add_stretches(const std::vector<double>& y, std::vector<Stretch>& list) {
  Swing whole;
  whole.add(y);
  const size_t count = std::min(kMostStretches, periods_of(y, 0, y.size(), whole.mean()) / kPeriods);
  for (size_t i = 0; i < count; ++i) {
    Swing swing;
    swing.add(y, i * y.size() / count, (i + 1) * y.size() / count);
    list.push_back({swing.mean(), 2 * swing.rms() * swing.rms()});
  }
}

}  // namespace

void Swing::add(const std::vector<double>& y, size_t from, size_t to) {
  if (to <= from) return;
  const size_t reach = eighth_of_a_period(y, from, to);
  for (size_t k = std::max(reach, from); k + reach < y.size() && k < to; ++k) {
    const double bell = std::sin(kPi * (static_cast<double>(k - from) + 0.5) / static_cast<double>(to - from));
    const double speed = y[k + reach] - y[k - reach], weight = bell * bell * speed * speed;
    sum_ += weight * y[k], squares_ += weight * y[k] * y[k], weights_ += weight;
  }
}

double Swing::rms() const { return weights_ > 0 ? std::sqrt(std::max(0.0, squares_ / weights_ - mean() * mean())) : 0; }

size_t clear_swings(const std::vector<double>& y) {
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(y.size());
  for (const double value : y) sum += value;
  for (const double value : y) squares += (value - sum / count) * (value - sum / count);
  return clear_swings(y, y.size(), sum / count, std::sqrt(squares / count));
}

double strays_by(const std::vector<double>& y) {
  Swing whole;
  whole.add(y);
  double most = 0;
  for (const size_t part : {2, 4, 8}) {
    Swing begin;
    begin.add(y, 0, y.size() / part);
    if (clear_swings(y, y.size() / part, begin.mean(), begin.rms()) < kPeriods) break;
    most = std::max(most, std::fabs(begin.mean() - whole.mean()));
  }
  return most;
}

std::optional<double> stays_at(const std::vector<double>& y) {
  Swing whole;
  whole.add(y);
  const size_t from = y.size() - y.size() / 4;
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(y.size() - from);
  for (size_t k = from; k < y.size(); ++k) sum += y[k];
  for (size_t k = from; k < y.size(); ++k) squares += (y[k] - sum / count) * (y[k] - sum / count);
  if (!(squares < count * kQuiet * whole.rms() * whole.rms())) return {};
  return sum / count;
}

// A line through the centres over the squares; what is left of a period at a stretch's ends moves its centre with the amplitude.
std::optional<double> centre_of_small_swings(const std::vector<const std::vector<double>*>& records) {
  std::vector<Stretch> list;
  for (const std::vector<double>* y : records) add_stretches(*y, list);
  if (list.empty()) return {};
  const auto quieter = [](const Stretch& a, const Stretch& b) { return a.square < b.square; };
  const double largest = std::max_element(list.begin(), list.end(), quieter)->square;
  list.erase(std::remove_if(list.begin(), list.end(), [&](const Stretch& s) { return !(s.square > kQuiet * largest); }),
             list.end());
  if (list.size() < kLeastStretches) return {};
  if (largest < kAmplitudes * std::min_element(list.begin(), list.end(), quieter)->square) return {};
  double n = 0, s = 0, ss = 0, c = 0, cs = 0;
  for (const Stretch& stretch : list) {
    const double weight = 1 / stretch.square;
    n += weight, s += weight * stretch.square, ss += weight * stretch.square * stretch.square;
    c += weight * stretch.centre, cs += weight * stretch.centre * stretch.square;
  }
  return (ss * c - s * cs) / (n * ss - s * s);
}

}  // namespace host_sim
