#include "host_sim/data_check/between_channels/kinematics.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/data_check/measures/unit_factors.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kFewestSpans = 30.0;
constexpr double kTurnedCorrelation = -0.6;  // of 30 spans: less than one in 10,000 by chance
constexpr double kGainCorrelation = 0.95;    // then noise bends the gain by less than 5 %
constexpr double kPlainGain = 3.0;           // no calibration is off by more
constexpr double kUnitTolerance = 0.05;
constexpr double kGoldenRatio = 0.6180339887498949;
constexpr size_t kMostPoints = 1024;  // of a span's length: a correlation of 0.95 is then known to 0.003
constexpr int kDelays = 3;            // samples that a channel may be late without its sign being in question

using Values = Eigen::Map<const Eigen::ArrayXd>;
Values view(const double* values, size_t count) { return {values, static_cast<Eigen::Index>(count)}; }

// Both sides of one pair of channels, over one span after the other. What the spans have in common is summed once.
class Sides {
 public:
  std::vector<double> from_lower, of_upper;  // centred at sample h + i, for every i or some

  Sides(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals)
      : lower_(lower.values),
        twice_(static_cast<int>(upper.quantity) - static_cast<int>(lower.quantity) == 2),
        T_(sample_period_s),
        integral_(integrals.of(upper, twice_)) {}

  size_t samples() const { return lower_.size(); }

  void over(size_t h) { compare(h, samples() - 2 * h, 1.0); }
  // Some of them: each shares over nine tenths of its span with the next, or they are enough anyway. The step is no whole number,
  // so that no period of the motion keeps time with it.
  void here_and_there(size_t h) {
    const size_t count = samples() - 2 * h, apart = count / kMostPoints;
    const double enough = kGoldenRatio * static_cast<double>(apart);
    const double step = std::max({1.0, kGoldenRatio * static_cast<double>(h) / 4.0, enough});
    compare(h, static_cast<size_t>(static_cast<double>(count - 1) / step) + 1, step);
  }

 private:
  // The mean of a mean over h steps is a second difference of the integral's integral.
  void compare(size_t h, size_t count, double step) {
    from_lower.resize(count);
    of_upper.resize(count);
    const double steps = static_cast<double>(h), part = twice_ ? 1.0 / (steps * steps) : 0.5 / steps;
    const double per_span = part / (twice_ ? T_ * T_ : T_);
    const double *lower = lower_.data(), *integral = integral_.data();
    double *from = from_lower.data(), *of = of_upper.data();
    const auto each = [&](auto difference) {
      for (size_t k = 0; k < count; ++k) {
        const size_t i = step == 1.0 ? k : static_cast<size_t>(static_cast<double>(k) * step);
        from[k] = difference(lower + i) * per_span;
        of[k] = difference(integral + i) * part;
      }
    };
    if (twice_)
      each([h](const double* at) { return at[2 * h] - 2.0 * at[h] + at[0]; });
    else
      each([h](const double* at) { return at[2 * h] - at[0]; });
  }

  const std::vector<double>& lower_;
  bool twice_;
  double T_;
  const std::vector<double>& integral_;  // of the upper channel's, once or twice
};

struct Moments {
  double pp = 0.0, qq = 0.0, pq = 0.0;
  double correlation() const { return pp > 0.0 && qq > 0.0 ? pq / std::sqrt(pp * qq) : 0.0; }
};

// Of q `lag` samples later, about the means.
Moments moments(const Sides& sides, int lag) {
  const size_t count = sides.from_lower.size(), shift = static_cast<size_t>(std::abs(lag));
  const size_t n = count - shift;
  const Values p = view(sides.from_lower.data() + (lag < 0 ? shift : 0), n);
  const Values q = view(sides.of_upper.data() + (lag > 0 ? shift : 0), n);
  const double mean_p = p.mean(), mean_q = q.mean();
  Moments m;
  m.pp = (p - mean_p).square().sum();
  m.qq = (q - mean_q).square().sum();
  m.pq = ((p - mean_p) * (q - mean_q)).sum();
  return m;
}

// The span where both sides agree best, and their correlation there; 0 where the record is too short to say.
struct BestSpan {
  size_t h = 0;
  double correlation = 0.0;
};
BestSpan best_span(Sides& sides) {
  BestSpan best;
  const double n = static_cast<double>(sides.samples());
  for (size_t h = 1; n / static_cast<double>(2 * h) >= kFewestSpans; h *= 2) {
    sides.here_and_there(h);
    const double r = moments(sides, 0).correlation();
    if (std::abs(r) > std::abs(best.correlation)) best = {h, r};
  }
  return best;
}

// q(t) = g p(t - late): the late part is what q - g p shares with the slope of p.
void measure_lateness(const Sides& sides, double T, size_t h, Comparison& result) {
  double slope_square = 0.0, shared = 0.0, residual = 0.0;
  const size_t n = sides.from_lower.size();
  const double mean_p = view(sides.from_lower.data(), n).mean(), mean_q = view(sides.of_upper.data(), n).mean();
  for (size_t i = 1; i + 1 < n; ++i) {
    const double slope = result.gain * (sides.from_lower[i + 1] - sides.from_lower[i - 1]) / (2.0 * T);
    const double off = sides.of_upper[i] - mean_q - result.gain * (sides.from_lower[i] - mean_p);
    slope_square += slope * slope;
    shared -= off * slope;
    residual += off * off;
  }
  if (!(slope_square > 0.0)) return;
  result.late_s = shared / slope_square;
  residual -= shared * shared / slope_square;
  result.late_std_s =
      std::sqrt(std::max(residual, 0.0) / static_cast<double>(n) * 2.0 * static_cast<double>(h) / slope_square);
}

// Whose numbers are too large, and in which unit they would be right. factor: upper over what lower says.
struct Blame {
  bool upper = true;
  std::string unit;
};
std::optional<Blame> blame_unit(const Comparison& pair, bool rotating) {
  const double factor = std::abs(pair.gain);
  const auto dimension = [&](Quantity q) { return dimension_of(static_cast<firmware::Quantity>(q), rotating); };
  if (const auto unit = unit_reading(dimension(pair.upper), factor, kUnitTolerance)) return Blame{true, *unit};
  if (const auto unit = unit_reading(dimension(pair.lower), 1.0 / factor, kUnitTolerance)) return Blame{false, *unit};
  return std::nullopt;
}

}  // namespace

const std::vector<double>& Integrals::of(const Channel& channel, bool twice) {
  const auto [entry, fresh] = made_.try_emplace({&channel, twice});
  std::vector<double>& sums = entry->second;
  if (!fresh) return sums;
  const std::vector<double>& values = twice ? of(channel, false) : channel.values;
  const double mean = view(values.data(), values.size()).mean();
  sums.resize(values.size());
  double sum = 0.0;
  for (size_t i = 0; i < values.size(); ++i) {
    const double half = 0.5 * (values[i] - mean);
    sums[i] = sum += half;
    sum += half;
  }
  return sums;
}

double agreement(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals) {
  Sides sides(lower, upper, sample_period_s, integrals);
  return std::abs(best_span(sides).correlation);
}

std::optional<Comparison> compare(const Channel& lower, const Channel& upper, double sample_period_s,
                                  Integrals& integrals) {
  Sides sides(lower, upper, sample_period_s, integrals);
  const BestSpan span = best_span(sides);
  if (span.h == 0) return std::nullopt;
  Comparison best;
  best.lower = lower.quantity;
  best.upper = upper.quantity;
  sides.over(span.h);
  const Moments at_once = moments(sides, 0);
  best.correlation = at_once.correlation();
  best.independent = static_cast<double>(sides.samples()) / static_cast<double>(2 * span.h);
  best.gain = std::copysign(std::sqrt(at_once.qq / at_once.pp), at_once.pq);
  best.turned = best.correlation < kTurnedCorrelation;
  for (int lag = -kDelays; best.turned && lag <= kDelays; ++lag) best.turned = moments(sides, lag).pq < 0.0;
  measure_lateness(sides, sample_period_s, span.h, best);
  return best;
}

std::vector<Finding> check_kinematics(const Record& record, int dof, bool rotating, const rig_file::RigModel* model,
                                      Integrals& integrals) {
  constexpr Quantity kMotion[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};
  std::vector<Comparison> pairs;
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j) {
      const Channel *lower = record.find(kMotion[i], dof), *upper = record.find(kMotion[j], dof);
      if (lower == nullptr || upper == nullptr) continue;
      if (const auto pair = compare(*lower, *upper, record.sample_period_s, integrals)) pairs.push_back(*pair);
    }
  const auto name = [&](Quantity quantity) { return record.find(quantity, dof)->name; };
  const auto stated_s = [&](Quantity quantity) {
    return model == nullptr ? 0.0 : rig_file::stated_delay_s(*model, name(quantity));
  };
  // With three channels the one that two pairs complain about; else the one that differentiates more.
  const auto count_bad = [&](Quantity quantity, auto is_bad) {
    return std::count_if(pairs.begin(), pairs.end(), [&](const Comparison& pair) {
      return (pair.lower == quantity || pair.upper == quantity) && is_bad(pair);
    });
  };
  std::vector<Finding> findings;
  const auto add = [&](Finding finding) {
    for (const Finding& earlier : findings)
      if (earlier.kind == finding.kind && earlier.channel == finding.channel) return;
    findings.push_back(std::move(finding));
  };
  const auto turned = [](const Comparison& pair) { return pair.turned; };
  const auto off = [](const Comparison& pair) {
    return std::abs(pair.correlation) > kGainCorrelation &&
           (std::abs(pair.gain) > kPlainGain || std::abs(pair.gain) < 1.0 / kPlainGain);
  };
  for (const Comparison& pair : pairs) {
    if (turned(pair)) {
      const bool lower = count_bad(pair.lower, turned) > count_bad(pair.upper, turned);
      const std::string blamed = name(lower ? pair.lower : pair.upper), other = name(lower ? pair.upper : pair.lower);
      Finding finding{"polarity", Weight::kFault, blamed, "", pair.correlation};
      finding.detail = "points against " + other +
                       fmt::format(" (correlation of the same motion {:.2f})", pair.correlation) +
                       ": the sensor is turned over or its leads are exchanged; change the sign of the column";
      if (pairs.size() == 1) finding.detail += " (or that of " + other + ")";
      add(std::move(finding));
    }
    if (off(pair)) {
      const auto blame = blame_unit(pair, rotating);
      bool upper = count_bad(pair.upper, off) >= count_bad(pair.lower, off);
      if (blame && count_bad(pair.upper, off) == count_bad(pair.lower, off)) upper = blame->upper;
      const double factor = upper ? std::abs(pair.gain) : 1.0 / std::abs(pair.gain);
      const std::string blamed = name(upper ? pair.upper : pair.lower), other = name(upper ? pair.lower : pair.upper);
      Finding finding{"unit", Weight::kFault, blamed, "", factor};
      finding.detail = "is " + fmt::format("{:.4g} times what ", factor) + other + " says of the same motion";
      const auto unit =
          unit_reading(dimension_of(static_cast<firmware::Quantity>(upper ? pair.upper : pair.lower), rotating), factor,
                       kUnitTolerance);
      finding.detail += unit ? ": its numbers are in " + *unit + "; name the unit in the column's head or with --unit"
                             : ": its unit or its calibration is wrong";
      add(std::move(finding));
    }
    const double late_s = pair.late_s - (stated_s(pair.upper) - stated_s(pair.lower));
    const double samples = late_s / record.sample_period_s;
    if (!pair.turned && pair.correlation > kGainCorrelation && std::abs(samples) > 0.1 && std::abs(samples) < 10.0 &&
        std::abs(late_s) > 5.0 * pair.late_std_s) {
      Finding finding{"skew", Weight::kInforms, name(pair.upper), "", late_s};
      finding.detail =
          fmt::format(late_s > 0.0 ? "is {:.3g} us late against " : "is {:.3g} us ahead of ", std::abs(late_s) * 1e6) +
          name(pair.lower) + fmt::format(" (+- {:.2g})", 2e6 * pair.late_std_s);
      add(std::move(finding));
    }
  }
  return findings;
}

}  // namespace host_sim::data_check
