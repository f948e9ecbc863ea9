#include "windows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace diagnosis::runs {
namespace {

constexpr double kAtRest = 0.05;      // of the record's motion: friction holds, and what holds is no law of motion
constexpr double kAboveNoise = 4;     // times what a record at rest still shows: less motion tells of noise
constexpr double kForcedPeriods = 8;  // a window; at least 12 of them
constexpr Index kLeastLength = 12;    // samples

Index a_period(const Prepared& p) { return std::max<Index>(2, static_cast<Index>(p.period_s / p.step_s)); }

// How a record moves: the rates of its DOFs.
class Motion {
 public:
  explicit Motion(const Prepared& record) : p_(record) {
    for (size_t d = 0; d + 1 < p_.guess.size(); ++d) rate_.emplace_back(p_.guess[d].v);
    double least = least_motion();
    if (least > kAtRest) {  // it never rests, or the rates from sample to sample are those of its noise
      const std::vector<Rate> fine = std::exchange(rate_, coarse_rates());
      const double least_of_coarse = least_motion();
      if (least_of_coarse > kAtRest)
        rate_ = fine;
      else
        least = least_of_coarse;
    }
    rest_ = least > kAtRest ? kAtRest : std::max(kAtRest, kAboveNoise * least);
  }
  // Of a stretch over that of the record, rms, of the DOF that moves most there.
  double of(Index from, Index length) const {
    double most = 0;
    for (const Rate& r : rate_)
      if (r.mean_square > 0)
        most = std::max(most, r.v.segment(from, length).squaredNorm() / static_cast<double>(length) / r.mean_square);
    return std::sqrt(most);
  }
  // The same of what is about the means: at constant speed nothing varies.
  double varies(Index from, Index length) const {
    double most = 0;
    for (const Rate& r : rate_) {
      const double all = rms_about_mean(r.v);
      if (all > 0) most = std::max(most, rms_about_mean(r.v.segment(from, length)) / all);
    }
    return most;
  }
  // Below it the record is at rest. One that comes to rest shows there what its motion owes to noise.
  double rest() const { return rest_; }
  const Prepared& record() const { return p_; }

 private:
  struct Rate {
    explicit Rate(const Vec& rate) : v(rate), mean_square(v.squaredNorm() / static_cast<double>(v.size())) {}
    Vec v;
    double mean_square;
  };
  double least_motion() const {
    const Index part = a_period(p_);
    double least = 1;
    for (Index from = 0; from + part <= p_.samples; from += part) least = std::min(least, of(from, part));
    return least;
  }
  // Over a quarter of a period, which takes noise of displacements down by as many samples.
  std::vector<Rate> coarse_rates() const {
    const Index half = std::max<Index>(1, a_period(p_) / 8);
    std::vector<Rate> list;
    for (size_t d = 0; d + 1 < p_.guess.size(); ++d) {
      const Vec& x = p_.guess[d].x;
      Vec rate(x.size());
      for (Index i = 0; i < x.size(); ++i) {
        const Index from = std::max<Index>(0, i - half), to = std::min<Index>(x.size() - 1, i + half);
        rate[i] = (x[to] - x[from]) / (static_cast<double>(std::max<Index>(1, to - from)) * p_.step_s);
      }
      list.emplace_back(rate);
    }
    return list;
  }
  const Prepared& p_;
  std::vector<Rate> rate_;
  double rest_;
};

// Of a period: a reversal of regular motion is no rest of that length.
constexpr Index kFine = 16;

// Of the record's motion: a last part that moves less, or at a speed as constant, shows little of what acts at the motion before. Then
// every third window is kept apart instead.
constexpr double kQuiet = 0.5;
constexpr double kConstant = 0.1;  // of what the record's rates vary
constexpr Index kEvery = 3;

// The length without the rest at its end.
Index until_rest(const Motion& m, Index from, Index length) {
  for (const Index part : {a_period(m.record()), std::max<Index>(2, a_period(m.record()) / kFine)})
    while (length > part && m.of(from + length - part, part) <= m.rest()) length -= part;
  return length;
}

// Samples of rest at its beginning, and the part of a period in which it is let go.
Index held_at_first(const Motion& m, Index from, Index length) {
  const Index part = std::max<Index>(2, a_period(m.record()) / kFine);
  Index held = 0;
  while (held + 2 * part < length && m.of(from + held, part) <= m.rest()) held += part;
  return held > 0 ? held + part : 0;
}

Span moving_span(const Motion& m, bool pushed) {
  const Index samples = m.record().samples, from = pushed ? 0 : held_at_first(m, 0, samples);
  return {from, from + until_rest(m, from, samples - from)};
}

}  // namespace

Span moving_span(const Prepared& p, bool pushed) { return moving_span(Motion(p), pushed); }

bool ends_steadily(const Prepared& p, bool pushed, double unseen_share) {
  const Motion motion(p);
  const Span all = moving_span(motion, pushed);
  const Index seen = all.from + static_cast<Index>((1 - unseen_share) * static_cast<double>(all.to - all.from));
  return pushed && seen < all.to && motion.varies(seen, all.to - seen) < kConstant;
}

double moving_share(const std::vector<Prepared>& records) {
  double moving = 0, all = 0;
  for (const Prepared& p : records) {
    const Index part = a_period(p);
    const Motion motion(p);
    for (Index from = 0; from + part <= p.samples; from += part)
      all += 1, moving += motion.of(from, part) > motion.rest() ? 1 : 0;
  }
  return all > 0 ? moving / all : 1;
}

bool forced(const std::vector<Prepared>& records) {
  for (const Prepared& p : records) {
    if (p.guess.back().given) return true;
    for (const Vec& f : p.force)
      if (f.size() && f.cwiseAbs().maxCoeff() > 0) return true;
  }
  return false;
}

double longest_horizon(const std::vector<Prepared>& records) {
  const bool driven = forced(records);
  double whole = 0, longest = 0;
  for (const Prepared& p : records) {
    const double periods = static_cast<double>(p.samples) * p.step_s / p.period_s;
    whole += periods, longest = std::max(longest, periods);
  }
  // what damps a decay shows in its envelope alone: the whole of it is one window
  return driven ? std::min(kForcedPeriods, 0.7 * whole / 12) : longest;
}

std::vector<Window> lay_windows(const std::vector<Prepared>& records, double periods, double unseen_share,
                                bool massless) {
  std::vector<Window> list;
  const bool driven = forced(records) && !massless;
  for (size_t r = 0; r < records.size(); ++r) {
    const Prepared& p = records[r];
    const Motion motion(p);
    const Span all = moving_span(motion, driven);
    Index seen = all.from + static_cast<Index>((1 - unseen_share) * static_cast<double>(all.to - all.from));
    const bool spread = driven && unseen_share > 0 && seen < all.to &&
                        (motion.of(seen, all.to - seen) < kQuiet || motion.varies(seen, all.to - seen) < kConstant);
    if (spread) seen = all.to;
    const auto cover = [&](Index from, Index to, bool unseen) {
      const double wanted = std::max<double>(static_cast<double>(kLeastLength), periods * p.period_s / p.step_s);
      const Index count = std::max<Index>(1, static_cast<Index>(static_cast<double>(to - from) / wanted + 0.5));
      for (Index i = 0; i < count; ++i) {
        Window w;
        w.record = r, w.from = from + i * (to - from) / count;
        w.length = from + (i + 1) * (to - from) / count - w.from;
        w.unseen = unseen || (spread && i % kEvery == kEvery - 1);
        if (!driven) {
          const Index held = held_at_first(motion, w.from, w.length);
          w.from += held, w.length = until_rest(motion, w.from, w.length - held);
        }
        if (w.length >= kLeastLength && motion.of(w.from, w.length) > motion.rest()) list.push_back(w);
      }
    };
    cover(all.from, seen, false);
    if (unseen_share > 0 && !spread) cover(seen, all.to, true);
  }
  return list;
}

}  // namespace diagnosis::runs
