#include "windows.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr double kAtRest = 0.05;      // of the record's motion: friction holds, and what holds is no law of motion
constexpr double kForcedPeriods = 8;  // a window; at least 12 of them
constexpr Index kLeastLength = 12;    // samples

double motion_of(const Prepared& p, Index from, Index length) {
  double sum = 0;
  for (size_t d = 0; d + 1 < p.guess.size(); ++d) {
    const Vec& v = p.guess[d].v;
    const double all = v.squaredNorm() / static_cast<double>(v.size());
    if (all > 0) sum = std::max(sum, v.segment(from, length).squaredNorm() / static_cast<double>(length) / all);
  }
  return std::sqrt(sum);
}

// The length without the rest at its end.
Index until_rest(const Prepared& p, Index from, Index length) {
  const Index part = std::max<Index>(2, static_cast<Index>(p.period_s / p.step_s));
  while (length > part && motion_of(p, from + length - part, part) <= kAtRest) length -= part;
  return length;
}

}  // namespace

bool forced(const std::vector<Prepared>& records) {
  for (const Prepared& p : records) {
    if (p.guess.back().given) return true;
    for (const Vec& f : p.force)
      if (f.size() && f.cwiseAbs().maxCoeff() > 0) return true;
  }
  return false;
}

Index moving_samples(const Prepared& p, const std::vector<Prepared>& records, bool massless) {
  return forced(records) && !massless ? p.samples : until_rest(p, 0, p.samples);
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
    const Index all = moving_samples(p, records, massless);
    const Index seen = static_cast<Index>((1 - unseen_share) * static_cast<double>(all));
    const auto cover = [&](Index from, Index to, bool unseen) {
      const double wanted = std::max<double>(static_cast<double>(kLeastLength), periods * p.period_s / p.step_s);
      const Index count = std::max<Index>(1, static_cast<Index>(static_cast<double>(to - from) / wanted + 0.5));
      for (Index i = 0; i < count; ++i) {
        Window w;
        w.record = r, w.from = from + i * (to - from) / count;
        w.length = from + (i + 1) * (to - from) / count - w.from;
        w.unseen = unseen;
        if (!driven) w.length = until_rest(p, w.from, w.length);
        if (w.length >= kLeastLength && motion_of(p, w.from, w.length) > kAtRest) list.push_back(w);
      }
    };
    cover(0, seen, false);
    if (unseen_share > 0) cover(seen, all, true);
  }
  return list;
}

}  // namespace diagnosis::runs
