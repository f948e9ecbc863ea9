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

size_t periods_of(const std::vector<double>& y, double mean) {
  size_t rises = 0;
  for (size_t k = 1; k < y.size(); ++k) rises += y[k - 1] < mean && y[k] >= mean;
  return rises;
}

struct Stretch {
  double centre = 0, square = 0;  // of the amplitude
};

void add_stretches(const std::vector<double>& y, std::vector<Stretch>& list) {
  Swing whole;
  whole.add(y);
  const size_t count = std::min(kMostStretches, periods_of(y, whole.mean()) / kPeriods);
  for (size_t i = 0; i < count; ++i) {
    Swing swing;
    swing.add(y, i * y.size() / count, (i + 1) * y.size() / count);
    list.push_back({swing.mean(), 2 * swing.rms() * swing.rms()});
  }
}

}  // namespace

void Swing::add(const std::vector<double>& y, size_t from, size_t to) {
  for (size_t k = std::max<size_t>(1, from); k + 1 < y.size() && k < to; ++k) {
    const double bell = std::sin(kPi * (static_cast<double>(k - from) + 0.5) / static_cast<double>(to - from));
    const double speed = y[k + 1] - y[k - 1], weight = bell * bell * speed * speed;
    sum_ += weight * y[k], squares_ += weight * y[k] * y[k], weights_ += weight;
  }
}

double Swing::rms() const { return weights_ > 0 ? std::sqrt(std::max(0.0, squares_ / weights_ - mean() * mean())) : 0; }

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
