#include "filtered_motion.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdio>

#include "../unseen/score.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kQuality[] = {0.541196100146197, 1.306562964876377};  // 1 / (2 cos(pi / 8)), 1 / (2 cos(3 pi / 8))
constexpr double kLag = 2.613125929752753;  // times 1 / (2 pi corner): its group delay far below it
constexpr double kHighest = 0.45;           // of the rate
// The lag that was fitted is that of the motion's band, where the filter's is up to a tenth longer, less what smoothed jumps bend it by.
constexpr double kBand = 1.5;
constexpr double kAlike = 0.05;  // of a mean square: two deviations of that of 3000 samples of noise
constexpr int kBits = 12;
constexpr uintmax_t kMostTrials = 20;

// Mean square over the DOFs of what a model misses of unseen data, percent of the motion squared.
double missed_square(const ModelScore& score) {
  double sum = 0;
  for (const double percent : score.holdout_nrmse_percent) sum += percent * percent;
  return sum / std::max<double>(1, static_cast<double>(score.holdout_nrmse_percent.size()));
}

// Second order, by the bilinear transform with the corner kept in place; at rest before the record.
void low_pass(double quality, double corner, std::vector<double>& y) {
  const double k = std::tan(0.5 * kTwoPi * corner), scale = 1 / (1 + k / quality + k * k);
  const double b = k * k * scale, a1 = 2 * (k * k - 1) * scale, a2 = (1 - k / quality + k * k) * scale;
  double x1 = y.empty() ? 0 : y[0], x2 = x1, y1 = x1, y2 = x1;
  for (double& sample : y) {
    const double x = sample;
    sample = b * (x + 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = x, y2 = y1, y1 = sample;
  }
}

double missed_behind(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                     const std::vector<host_sim::Record>& holdout, double corner_Hz) {
  const System system = make_system(rig);
  const std::vector<Prepared> records =
      prepare_all(rig, forces_behind(training, corner_Hz), forces_behind(holdout, corner_Hz));
  const Task task{system, records, training.size()};
  const Choice choice = rig_fitted(task);
  if (!choice.base.fit.ok) return 1e300;
  ModelScore score;
  score.holdout_nrmse_percent = score_unseen(task, choice.base).nrmse_percent;
  return missed_square(score);
}

}  // namespace

std::vector<host_sim::Record> forces_behind(std::vector<host_sim::Record> records, double corner_Hz) {
  for (host_sim::Record& r : records)
    for (host_sim::Channel& c : r.channels)
      for (const double quality : kQuality)
        if (c.quantity == host_sim::Quantity::kForce) low_pass(quality, corner_Hz * r.sample_period_s, c.values);
  return records;
}

double corner_of_motion_Hz(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                           const std::vector<host_sim::Record>& holdout, double lag_s) {
  const double middle_Hz = kLag / (kTwoPi * lag_s), highest_Hz = kHighest / training[0].sample_period_s;
  const double from = std::log(middle_Hz / kBand), to = std::log(std::min(kBand * middle_Hz, highest_Hz));
  if (!(from < to)) return 0;
  const auto missed = [&](double log_Hz) { return missed_behind(rig, training, holdout, std::exp(log_Hz)); };
  uintmax_t most = kMostTrials;
  return std::exp(boost::math::tools::brent_find_minima(missed, from, to, kBits, most).first);
}

namespace {

void widen(std::vector<diagnosis::Parameter>& numbers, const std::vector<diagnosis::Parameter>& by) {
  for (diagnosis::Parameter& p : numbers)
    for (const diagnosis::Parameter& o : by)
      if (o.name == p.name && p.std > 0) p.std = std::hypot(p.std, p.value - o.value);
}

std::string of_filter(double corner_Hz) {
  char text[200];
  std::snprintf(text, sizeof text,
                "all motion channels lag the force as behind a low-pass of fourth order at %.3g Hz on them alone: the "
                "force has passed the same before the rig is judged",
                corner_Hz);
  return text;
}

}  // namespace

Diagnosis of_lag_and_filter(const Diagnosis& behind_lag, const Diagnosis& behind_filter, double corner_Hz) {
  const double with_lag = missed_square(behind_lag.extended), with_filter = missed_square(behind_filter.extended);
  const bool filtered = with_filter < with_lag;
  Diagnosis d = filtered ? behind_filter : behind_lag;
  const Diagnosis& other = filtered ? behind_lag : behind_filter;
  if (std::abs(with_filter - with_lag) < kAlike * with_lag)
    widen(d.baseline.parameters, other.baseline.parameters), widen(d.extended.parameters, other.extended.parameters);
  if (!filtered) return d;
  d.extended_rig.channels = behind_lag.extended_rig.channels;  // a rig file knows a delay
  d.advice.insert(d.advice.begin(), of_filter(corner_Hz));
  return d;
}

}  // namespace diagnosis::runs
