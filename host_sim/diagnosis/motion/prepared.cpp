#include "prepared.hpp"

#include <algorithm>
#include <cmath>

#include "../record/fourier.hpp"
#include "../record/motion.hpp"
#include "fused.hpp"
#include "host_sim/records/value_step.hpp"

namespace diagnosis::runs {

bool massless(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& d) { return !d.mass_kg.estimate && d.mass_kg.value == 0; });
}

double rms_about_mean(const Vec& y) { return std::sqrt((y.array() - y.mean()).square().mean()); }

double white_noise_sum(const Vec& y) {
  const Index n = y.size() - 3;
  if (n < 1) return 0;
  return (y.tail(n) - 3 * y.segment(2, n) + 3 * y.segment(1, n) - y.head(n)).squaredNorm() / 20;
}

namespace {

constexpr double kSamplesPerTop = 24;  // of the fastest motion: one Runge-Kutta step each is right to 1e-4
constexpr double kPowerBelowTop = 0.999;
constexpr double kPowerOfDisplacement = 0.9999;  // its velocity, on which friction acts, is faster
constexpr Index kLeast = 100;
constexpr double kOutside = 0.01;           // of a motion's square sum: a tenth of its amplitude, where it goes on
constexpr double kMedianOfNormal = 0.6745;  // of a normal law's magnitude, per standard deviation
constexpr double kBlowOverNoise = 30;       // a random force reaches 5 times what its median says
constexpr double kBlowsShare = 0.2;         // of the samples, at most

// Where a record is rest for the most part, the part that holds all but a hundredth of its motion's square sum; else all of it. A taper over
// the whole of a short decay takes the decay itself away.
Vec moving_part(const Vec& y) {
  std::vector<double> order(y.data(), y.data() + y.size());
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2), order.end());
  const double middle = order[order.size() / 2], noise = white_noise_sum(y) / static_cast<double>(y.size());
  Vec sum(y.size());
  double so_far = 0;
  for (Index i = 0; i < y.size(); ++i) sum[i] = so_far += (y[i] - middle) * (y[i] - middle) - noise;
  Index from = 0, to = y.size();
  while (from < to && sum[from] < kOutside / 2 * so_far) ++from;
  while (to > from + 1 && sum[to - 2] > (1 - kOutside / 2) * so_far) --to;
  const bool mostly_rest = so_far > 0 && 2 * (to - from) < y.size() && to - from >= kLeast;
  return mostly_rest ? Vec(y.segment(from, to - from)) : y;
}

// About its mean under a Hann taper of unit mean square: what its spectrum shows at high frequencies is not that of the ends.
Vec tapered(const Vec& y) {
  Vec w = y.array() - y.mean();
  for (Index i = 0; i < w.size(); ++i)
    w[i] *= (0.5 - 0.5 * std::cos(kTwoPi * static_cast<double>(i) / static_cast<double>(w.size()))) / std::sqrt(0.375);
  return w;
}

// Frequency below which nearly all power above the noise floor lies.
double top_frequency(const Vec& whole, double step_s, bool displacement) {
  const Vec y = moving_part(whole);
  const size_t n = fast_length(static_cast<size_t>(y.size()));
  const Vec p = Fourier(n).forward(tapered(y.head(static_cast<Index>(n)))).cwiseAbs2();
  std::vector<double> upper(p.data() + p.size() / 2, p.data() + p.size());
  std::nth_element(upper.begin(), upper.begin() + static_cast<std::ptrdiff_t>(upper.size() / 2), upper.end());
  const double floor = upper[upper.size() / 2] / kMedianOfSpread;
  // smoothed over 9 bins, less the floor
  double total = 0;
  Vec net = Vec::Zero(p.size());
  for (Index i = 0; i < p.size(); ++i) {
    const Index a = std::max<Index>(0, i - 4), b = std::min(p.size() - 1, i + 4);
    const double level = p.segment(a, b - a + 1).mean();
    net[i] = level > 4 * floor ? level - floor : 0;
    total += net[i];
  }
  double sum = 0;
  for (Index i = 0; i < p.size(); ++i) {
    sum += net[i];
    if (sum >= (displacement ? kPowerOfDisplacement : kPowerBelowTop) * total)
      return static_cast<double>(std::max<Index>(i, 2)) / (static_cast<double>(n) * step_s);
  }
  return 0.5 / step_s;
}

// Low-pass of windowed-sinc shape for thinning out by `by`; ends are left out (3 by samples each).
Vec thinned(const Vec& y, int by) {
  if (by <= 1) return y;
  const Index half = 3 * by;
  Vec kernel(2 * half + 1);
  for (Index i = -half; i <= half; ++i) {
    const double t = static_cast<double>(i) / by * 0.8, s = i == 0 ? 1 : std::sin(kTwoPi / 2 * t) / (kTwoPi / 2 * t);
    kernel[i + half] =
        s * (0.54 + 0.46 * std::cos(kTwoPi / 2 * static_cast<double>(i) / static_cast<double>(half + 1)));
  }
  kernel /= kernel.sum();
  const Index count = (y.size() - 2 * half - 1) / by + 1;
  Vec out(count);
  for (Index i = 0; i < count; ++i) out[i] = kernel.dot(y.segment(i * by, 2 * half + 1));
  return out;
}

// Local cubic over 2 half + 1 samples: value and slope of the record (Savitzky and Golay).
void smooth_cubic(const Vec& y, Index half, double step_s, Vec* value, Vec* slope) {
  const Index n = y.size();
  double s2 = 0, s4 = 0, s6 = 0;
  for (Index i = -half; i <= half; ++i) {
    const double q = static_cast<double>(i * i);
    s2 += q, s4 += q * q, s6 += q * q * q;
  }
  const double s0 = static_cast<double>(2 * half + 1), d0 = s0 * s4 - s2 * s2, d1 = s2 * s6 - s4 * s4;
  if (value) value->resize(n);
  if (slope) slope->resize(n);
  for (Index c = 0; c < n; ++c) {
    const Index m = std::clamp(c, half, n - 1 - half);
    double a0 = 0, a1 = 0, a2 = 0, a3 = 0;
    for (Index i = -half; i <= half; ++i) {
      const double t = static_cast<double>(i), q = t * t, f = y[m + i];
      a0 += f * (s4 - s2 * q) / d0, a2 += f * (s0 * q - s2) / d0;
      a1 += f * t * (s6 - s4 * q) / d1, a3 += f * t * (s2 * q - s4) / d1;
    }
    const double t = static_cast<double>(c - m);
    if (value) (*value)[c] = a0 + t * (a1 + t * (a2 + t * a3));
    if (slope) (*slope)[c] = (a1 + t * (2 * a2 + 3 * t * a3)) / step_s;
  }
}

// The straight line that fits a stretch best, at one of its samples.
double line_at(const Vec& y, Index from, Index count, Index at) {
  const double middle = 0.5 * static_cast<double>(count - 1), n = static_cast<double>(count);
  double slope = 0;
  for (Index i = 0; i < count; ++i) slope += (static_cast<double>(i) - middle) * y[from + i];
  slope /= std::max(1.0, n * (n * n - 1) / 12);
  return y.segment(from, count).mean() + slope * (static_cast<double>(at - from) - middle);
}

// Integrates and takes off what is slower than two periods: a moving mean, at the ends a straight line.
Vec integrated(const Vec& y, double step_s, Index slow) {
  Vec z(y.size());
  z[0] = 0;
  for (Index i = 1; i < y.size(); ++i) z[i] = z[i - 1] + 0.5 * step_s * (y[i] + y[i - 1]);
  Vec sums(z.size() + 1);
  sums[0] = 0;
  for (Index i = 0; i < z.size(); ++i) sums[i + 1] = sums[i] + z[i];
  const Index n = z.size(), half = std::max<Index>(1, std::min(slow, (n - 1) / 2)), whole = 2 * half + 1;
  Vec out(n);
  for (Index i = half; i + half < n; ++i)
    out[i] = z[i] - (sums[i + half + 1] - sums[i - half]) / static_cast<double>(whole);
  const double first = line_at(z, 0, whole, 0), last = line_at(z, n - whole, whole, n - 1);
  const double inner = line_at(z, 0, whole, half), outer = line_at(z, n - whole, whole, n - 1 - half);
  for (Index i = 0; i < half; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(half);
    out[i] = z[i] - (first + share * (inner - first)), out[n - 1 - i] = z[n - 1 - i] - (last + share * (outer - last));
  }
  return out;
}

Guess guess_of(const std::vector<const Vec*>& measured, double step_s, Index half, Index slow) {
  Guess g;
  g.given = true;
  if (measured[0]) {
    smooth_cubic(*measured[0], half, step_s, &g.x, &g.v);
  }
  if (measured[1]) {
    smooth_cubic(*measured[1], half, step_s, &g.v, &g.a);
    if (!measured[0]) g.x = integrated(*measured[1], step_s, slow);
  }
  if (measured[2]) {
    g.a = *measured[2];
    if (!measured[0] && !measured[1]) {
      g.v = integrated(Vec(g.a.array() - g.a.mean()), step_s, slow), g.x = integrated(g.v, step_s, slow);
    }
  }
  if (g.a.size() == 0) smooth_cubic(g.v, half, step_s, nullptr, &g.a);
  return g;
}

bool driven(const Prepared& p) {
  const auto acts = [](const Vec& y) { return y.size() > 0 && y.cwiseAbs().maxCoeff() > 0; };
  return std::any_of(p.force.begin(), p.force.end(), acts) ||
         std::any_of(p.base.reading.begin(), p.base.reading.end(), acts);
}

bool touches_ground(const rig_file::RigModel& rig) {
  return std::any_of(rig.links.begin(), rig.links.end(),
                     [](const rig_file::Link& l) { return l.a == rig_file::kGround || l.b == rig_file::kGround; });
}

// Only accelerations are known, and only against the base do they say where a DOF is.
bool rides_on_base(const rig_file::RigModel& rig, const Prepared& p) {
  return p.base.reading[2].size() > 0 && p.base.reading[0].size() + p.base.reading[1].size() == 0 &&
         !touches_ground(rig) &&
         std::all_of(p.traces.begin(), p.traces.end(), [](const MotionTrace& t) { return t.quantity == 2; });
}

// Of a decay: the mean of its last part, whose swings are the smallest.
double middle(const Vec& y) { return y.tail(std::max<Index>(1, y.size() / 5)).mean(); }

struct Needs {
  int by = 1;
  double top_Hz = 0;
};
Needs needs_of(const host_sim::Record& record) {
  Needs needs;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity == host_sim::Quantity::kForce) continue;
    const Vec y = Vec::Map(c.values.data(), static_cast<Index>(c.values.size()));
    needs.top_Hz = std::max(needs.top_Hz,
                            top_frequency(y, record.sample_period_s, c.quantity == host_sim::Quantity::kDisplacement));
  }
  const double wanted = 1 / (record.sample_period_s * kSamplesPerTop * needs.top_Hz);
  const double most = static_cast<double>(record.samples()) / 4000;  // short work as it is
  needs.by = std::max(1, static_cast<int>(std::min(wanted, most)));
  return needs;
}

// A force and what the force window of modal testing takes off it.
struct Windowed {
  Vec force, off;
  Vec blow;  // 1 where a blow is, 0 between; empty: no window
};

// The force window of modal testing: between the blows of a hammer the force is nought, and what its channel shows there is noise,
// which would drive the simulated rig. Everything farther than a blow's own length from any blow becomes the channel's median.
Windowed windowed(const Vec& f) {
  const auto median_of = [](Vec y) {
    std::nth_element(y.begin(), y.begin() + y.size() / 2, y.end());
    return y[y.size() / 2];
  };
  const double zero = median_of(f), sigma = median_of((f.array() - zero).abs()) / kMedianOfNormal;
  const auto quiet = [&](Index i) { return std::abs(f[i] - zero) <= kNoiseReaches * sigma; };
  Index loud = 0;
  for (Index i = 0; i < f.size(); ++i) loud += !quiet(i);
  const double peak = (f.array() - zero).abs().maxCoeff();
  if (!(peak > kBlowOverNoise * sigma) || static_cast<double>(loud) > kBlowsShare * static_cast<double>(f.size()))
    return {f, {}, {}};
  Windowed w{f, Vec::Zero(f.size()), Vec::Zero(f.size())};
  for (Index i = 0; i < f.size();) {
    Index to = i;
    while (to < f.size() && !quiet(to)) ++to;
    // lone samples beyond the noise are noise
    const Index reach = to - i, from = std::max<Index>(0, i - reach), until = std::min(f.size(), to + reach);
    if (reach > 1) w.blow.segment(from, until - from).setOnes();
    i = to + 1;
  }
  for (Index i = 0; i < f.size(); ++i)
    if (w.blow[i] == 0) w.force[i] = zero, w.off[i] = f[i] - zero;
  return w;
}

// Standard deviation of a windowed force's noise, sample by sample: what shows between the blows is in them too.
Vec noise_in_blows(const Windowed& w, int by) {
  if (w.blow.size() == 0) return {};
  const Vec off = thinned(w.off, by);
  Vec blow = thinned(w.blow, by);
  for (double& share : blow) share = share > 0.5 ? 1 : 0;
  const double quiet = static_cast<double>(blow.size()) - blow.sum();
  return std::sqrt(off.squaredNorm() / std::max(1.0, quiet)) * blow;
}

double period_of(const Prepared& p) {
  double longest = 0;
  for (size_t i = 0; i < p.guess.size(); ++i) {
    const Guess& g = p.guess[i];
    if (!g.given) continue;
    const double v = rms_about_mean(g.v), x = rms_about_mean(g.x);
    if (v > 0) longest = std::max(longest, kTwoPi * x / v);
  }
  return longest;
}

Prepared prepare_by(const rig_file::RigModel& rig, const host_sim::Record& record, const Needs& needs) {
  Prepared p;
  p.file = record.file;
  p.step_s = record.sample_period_s * needs.by;
  p.read_every_s = record.sample_period_s;
  p.top_Hz = needs.top_Hz;
  const auto series = [&](const host_sim::Channel& c) {
    return thinned(Vec::Map(c.values.data(), static_cast<Index>(c.values.size())), needs.by);
  };
  const int n = static_cast<int>(rig.dofs.size());
  p.force.resize(static_cast<size_t>(n)), p.noise_in_blows.resize(static_cast<size_t>(n));
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity == host_sim::Quantity::kForce && c.dof >= 1 && c.dof <= n) {
      const Vec raw = Vec::Map(c.values.data(), static_cast<Index>(c.values.size()));
      const Windowed f = massless(rig) ? Windowed{raw, {}, {}} : windowed(raw);
      const size_t d = static_cast<size_t>(c.dof - 1);
      p.force[d] = thinned(f.force, needs.by), p.noise_in_blows[d] = noise_in_blows(f, needs.by);
      continue;
    }
    const int quantity = c.quantity == host_sim::Quantity::kDisplacement ? 0
                         : c.quantity == host_sim::Quantity::kVelocity   ? 1
                                                                         : 2;
    if (c.dof == rig_file::kBase)
      p.base.reading[static_cast<size_t>(quantity)] = series(c);
    else if (c.dof >= 1 && c.dof <= n)
      p.traces.push_back({c.dof - 1, quantity, c.name, series(c), host_sim::value_step(c.values)});
  }
  for (const MotionTrace& t : p.traces) p.samples = t.y.size();
  // Where nothing drives the motion its middle is free anyway: runs start from it, wherever the sensor has its zero.
  if (!driven(p))
    for (MotionTrace& t : p.traces)
      if (t.quantity == 0) t.y.array() -= middle(t.y);
  if (p.samples < kLeast)
    throw CannotAnswer(record.file + ": " + std::to_string(record.samples()) +
                       " samples; a diagnosis needs at least 400");
  p.smooth_half = std::clamp<Index>(static_cast<Index>(0.15 / (p.top_Hz * p.step_s)), 2, p.samples / 8);
  p.slow_half = std::clamp<Index>(static_cast<Index>(8 / (p.top_Hz * p.step_s)), 8, p.samples / 3);
  p.base.ridden = rides_on_base(rig, p);
  renew_motion(p);
  return p;
}

}  // namespace

void renew_motion(Prepared& p) {
  p.guess.clear();
  for (size_t d = 0; d < p.force.size(); ++d) {
    std::vector<const Vec*> measured(3, nullptr);
    for (const MotionTrace& t : p.traces)
      if (t.dof == static_cast<int>(d)) measured[static_cast<size_t>(t.quantity)] = &t.y;
    if (!measured[0] && !measured[1] && !measured[2])
      throw CannotAnswer(p.file + ": no displacement, velocity or acceleration of DOF " + std::to_string(d + 1) +
                         "; measure one of them");
    Vec against_base;
    if (p.base.ridden) against_base = *measured[2] - p.base.reading[2], measured[2] = &against_base;
    p.guess.push_back(guess_of(measured, p.step_s, p.smooth_half, p.slow_half));
    if (p.base.ridden) p.guess.back().a += p.base.reading[2];
  }
  p.guess.push_back({});
  renew_base(p);
  p.period_s = period_of(p);
}

void renew_base(Prepared& p) {
  if (!p.base.given()) return;
  const auto measured = [&](size_t quantity) {
    return p.base.reading[quantity].size() ? &p.base.reading[quantity] : nullptr;
  };
  const bool slower = measured(0) || measured(1);
  p.guess.back() = measured(2) && slower
                       ? fused_by_acceleration(measured(0), measured(1), *measured(2), p.step_s)
                       : guess_of({measured(0), measured(1), measured(2)}, p.step_s, p.smooth_half, p.slow_half);
  if (measured(2) && slower && !measured(0)) p.guess.back().x = integrated(p.guess.back().v, p.step_s, p.slow_half);
  if (p.base.ridden) p.guess.back().x.setZero(), p.guess.back().v.setZero();
}

Prepared prepare(const rig_file::RigModel& rig, const host_sim::Record& record) {
  return prepare_by(rig, record, needs_of(record));
}

std::vector<Prepared> prepare_all(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                                  const std::vector<host_sim::Record>& holdout) {
  std::vector<const host_sim::Record*> records;
  for (const auto* list : {&training, &holdout})
    for (const host_sim::Record& r : *list) records.push_back(&r);
  std::vector<Needs> needs;
  double step_s = 1e300;
  for (const host_sim::Record* r : records) {
    needs.push_back(needs_of(*r));
    step_s = std::min(step_s, r->sample_period_s * needs.back().by);
  }
  std::vector<Prepared> list;
  double begins_s = 0;
  for (size_t i = 0; i < records.size(); ++i) {
    needs[i].by = std::max(1, static_cast<int>(step_s / records[i]->sample_period_s + 1e-6));
    list.push_back(prepare_by(rig, *records[i], needs[i]));
    list[i].middle_s = begins_s + 0.5 * list[i].time_s(list[i].samples);
    begins_s += list[i].time_s(list[i].samples);
  }
  double mean_s = 0;
  for (const Prepared& p : list) mean_s += p.middle_s / static_cast<double>(list.size());
  for (Prepared& p : list) p.middle_s -= mean_s;
  return list;
}

double noise_level(const Vec& f) {
  if (f.size() == 0 || f.cwiseAbs().maxCoeff() == 0) return 0;
  const size_t n = fast_length(static_cast<size_t>(f.size()));
  const Vec power = Fourier(n).forward(tapered(f.head(static_cast<Index>(n)))).cwiseAbs2() / static_cast<double>(n);
  std::vector<double> top(power.data() + power.size() * 2 / 3, power.data() + power.size() * 4 / 5);
  std::nth_element(top.begin(), top.begin() + static_cast<std::ptrdiff_t>(top.size() / 2), top.end());
  return std::sqrt(top[top.size() / 2] / kMedianOfSpread);
}

Vec noise_along_force(const Prepared& p, size_t dof) {
  if (dof < p.noise_in_blows.size() && p.noise_in_blows[dof].size()) return p.noise_in_blows[dof];
  return Vec::Constant(p.force[dof].size(), noise_level(p.force[dof]));
}

double noise_of_force(const Prepared& p, size_t dof) {
  return p.force[dof].size() ? noise_along_force(p, dof).maxCoeff() : 0;
}

double between(const Vec& y, Index sample, double share) {
  const Index n = y.size();
  if (n < 6) return y[std::clamp<Index>(sample, 0, n - 1)];
  const Index first = std::clamp<Index>(sample - 2, 0, n - 6);
  const double t = static_cast<double>(sample - first) + share;
  double sum = 0;
  constexpr double kDenominator[6] = {-120, 24, -12, 12, -24, 120};
  for (int i = 0; i < 6; ++i) {
    double product = 1;
    for (int j = 0; j < 6; ++j)
      if (j != i) product *= t - j;
    sum += y[first + i] * product / kDenominator[i];
  }
  return sum;
}

Vec delayed(const Vec& y, double samples) {
  Vec out(y.size());
  for (Index i = 0; i < y.size(); ++i) {
    const double t = std::clamp(static_cast<double>(i) - samples, 0.0, static_cast<double>(y.size() - 1));
    const Index k = std::min<Index>(static_cast<Index>(t), y.size() - 1);
    out[i] = between(y, k, t - static_cast<double>(k));
  }
  return out;
}

}  // namespace diagnosis::runs
