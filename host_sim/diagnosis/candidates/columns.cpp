#include "columns.hpp"

#include <algorithm>
#include <cmath>

#include "../fit/outer_sums.hpp"

namespace diagnosis::runs {
namespace {

int node_of(int end) { return end > 0 ? end - 1 : -1; }

Vec slope_of(const Vec& h, double step_s) {
  Vec out = Vec::Zero(h.size());
  for (Index i = 0; i < h.size(); ++i) {
    const Index a = std::max<Index>(0, i - 1), b = std::min(h.size() - 1, i + 1);
    out[i] = i >= 2 && i + 2 < h.size() ? (8 * (h[i + 1] - h[i - 1]) - (h[i + 2] - h[i - 2])) / (12 * step_s)
                                        : (h[b] - h[a]) / (static_cast<double>(b - a) * step_s);
  }
  return out;
}

// Whether a link's elongation holds the drift of a base whose displacement nobody measured.
bool drifts_with_base(const rig_file::Link& link, const Prepared& record) {
  const Base& base = record.base;
  return (link.a == rig_file::kBase || link.b == rig_file::kBase) && base.given() && !base.ridden &&
         base.reading[0].size() == 0;
}

// Does a simulation miss half of a link's elongation? What acts there acted along the measured one.
template <typename Simulated, typename Measured>
bool is_lost(Index len, Simulated simulated, Measured measured) {
  double missed = 0, sum = 0, square = 0;
  for (Index k = 0; k < len; ++k) {
    const double u = measured(k), error = simulated(k) - u;
    missed += error * error, sum += u, square += u * u;
  }
  return missed > 0.25 * (square - sum * sum / static_cast<double>(len));
}

}  // namespace

double Columns::base(const Window& w, Index k, bool rate) const {
  const Guess& g = records_[w.record].guess.back();
  return g.given ? (rate ? g.v : g.x)[w.from + k] : 0;
}

void Columns::base_delay(const Window& w, const WindowRun& run, Mat& forces, Vec& carried) const {
  const Prepared& record = records_[w.record];
  const Guess& g = record.guess.back();
  forces.setZero(run.x.rows(), w.length), carried.setZero(w.length);
  if (record.base.ridden) {
    carried = slope_of(g.a, record.step_s).segment(w.from, w.length);
    for (const ModelTerm& t : model_)
      if (t.term.kind == Kind::kMass || t.term.kind == Kind::kMassError) forces.row(t.term.dof) -= t.value * carried;
    return;
  }
  for (const ModelTerm& t : model_) {
    if (t.term.link < 0 || t.host >= 0) continue;
    const rig_file::Link& l = system_.links[static_cast<size_t>(t.term.link)];
    const bool first = l.a == rig_file::kBase;
    if (!first && l.b != rig_file::kBase) continue;
    const int dof = first ? l.b : l.a;
    if (dof < 1) continue;
    for (Index k = 0; k < w.length; ++k) {
      const double turn = first ? -1 : 1;
      const double u = turn * (run.x(dof - 1, k) - base(w, k, false)),
                   v = turn * (run.v(dof - 1, k) - base(w, k, true));
      const LawValue f = law(t.term.kind, u, v, record.time_s(w.from + k), t.term.shape, t.term.shape2);
      forces(dof - 1, k) += t.value * (f.by_u * g.v[w.from + k] + f.by_w * g.a[w.from + k]);
    }
  }
}

// Positive against the motion of the link's first end, or of the DOF.
Vec Columns::force(const Term& t, const Window& w, const WindowRun& run, Memory& memory) const {
  const Index len = w.length;
  const Prepared& record = records_[w.record];
  const double h = record.step_s;
  const bool follows = memory.ends == w.from && memory.record == w.record;
  Vec out(len);
  if (t.link >= 0) {
    const rig_file::Link& l = system_.links[static_cast<size_t>(t.link)];
    const auto end = [&](const Mat& m, int dof, Index k, bool rate) {
      return dof > 0 ? m(dof - 1, k) : dof == rig_file::kBase ? base(w, k, rate) : 0.0;
    };
    const auto measured = [&](int dof, Index k, bool rate) {
      if (dof <= 0) return dof == rig_file::kBase ? base(w, k, rate) : 0.0;
      const Guess& g = record.guess[static_cast<size_t>(dof - 1)];
      return (rate ? g.v : g.x)[w.from + k];
    };
    const auto simulated = [&](Index k, bool rate) {
      const Mat& m = rate ? run.v : run.x;
      return end(m, l.a, k, rate) - end(m, l.b, k, rate);
    };
    // of what drifts the rate tells: a drift is slow
    const bool by_rate = drifts_with_base(l, record);
    const bool lost = is_lost(
        len, [&](Index k) { return simulated(k, by_rate); },
        [&](Index k) { return measured(l.a, k, by_rate) - measured(l.b, k, by_rate); });
    const auto along = [&](Index k, bool rate) {
      return lost ? measured(l.a, k, rate) - measured(l.b, k, rate) : simulated(k, rate);
    };
    const auto rate = [&](Index k) { return along(k, true); };
    const auto sign = [&](Index k) {
      const double spread = 0.25 * std::abs(rate(std::min(len - 1, k + 1)) - rate(std::max<Index>(0, k - 1)));
      const double value = rate(k);
      return spread > 0 ? std::clamp(value / spread, -1.0, 1.0) : value < 0 ? -1.0 : 1.0;
    };
    double before = 0;
    const bool replaces = t.kind == Kind::kPresliding && [&] {
      for (const ModelTerm& m : model_)
        if (m.term.link == t.link && (m.term.kind == Kind::kCoulomb || m.term.kind == Kind::kMissingCoulomb))
          return true;
      return false;
    }();
    for (Index k = 0; k < len; ++k) {
      const double u = along(k, false), v = rate(k);
      switch (t.kind) {
        case Kind::kMissingCoulomb:
          out[k] = sign(k);
          break;
        case Kind::kCogging:  // finer than what a simulation without it hits: along the way as measured
          out[k] = law(t.kind, measured(l.a, k, false) - measured(l.b, k, false), v, 0, t.shape, t.shape2).force;
          break;
        case Kind::kStribeck:
          out[k] = sign(k) * std::exp(-std::abs(v) / t.shape);
          break;
        case Kind::kPresliding: {
          if (k == 0 && !follows) memory.z = v < 0 ? -1 : 1;
          if (k > 0) {
            const double way = u - before, s = way < 0 ? -1 : 1;
            memory.z = s + (memory.z - s) * std::exp(-std::abs(way) / t.shape);
          }
          out[k] = memory.z - (replaces ? sign(k) : 0);
          break;
        }
        default:
          out[k] = law(t.kind, u, v, law_time(record.time_s(w.from + k), t.shape, record), t.shape, t.shape2).force;
          if ((t.kind == Kind::kStiffnessError || t.kind == Kind::kMissingViscous) && t.shape > 0)  // it pulsates, Hz
            out[k] *= std::cos(kTwoPi * t.shape * record.time_s(w.from + k) + t.shape2);
      }
      before = u;
    }
    memory.ends = w.from + len, memory.record = w.record;
    return out;
  }
  const Index d = t.dof;
  if (t.kind == Kind::kMassError) return run.a.row(d);
  if (t.kind == Kind::kResonance) {  // Newmark, average acceleration
    const double o = kTwoPi * t.shape, c = 2 * t.shape2 * o, q = o * o,
                 yield = 1 / (1 + 0.5 * h * c + 0.25 * h * h * q);
    if (!follows) memory.z = run.x(d, 0), memory.v = run.v(d, 0);
    const auto carried = [&](Index k) { return record.base.ridden ? record.guess.back().a[w.from + k] : 0.0; };
    // a: against the ground; z and s: against the base where that carries the rig
    double z = memory.z, s = memory.v, a = c * (run.v(d, 0) - s) + q * (run.x(d, 0) - z);
    for (Index k = 0; k < len; ++k) {
      out[k] = a;
      const Index n = std::min(len - 1, k + 1);
      const double now = a - carried(k), lost = carried(n);
      const double zp = z + h * s + 0.25 * h * h * (now - lost), sp = s + 0.5 * h * (now - lost);
      const double next = (c * (run.v(d, n) - sp) + q * (run.x(d, n) - zp)) * yield;
      z = zp + 0.25 * h * h * next, s = sp + 0.5 * h * next, a = next;
    }
    memory.z = z, memory.v = s, memory.ends = w.from + len, memory.record = w.record;
    return out;
  }
  const Vec f = record.force[static_cast<size_t>(d)].segment(w.from, len);
  if (t.kind == Kind::kDeadBand) return f.cwiseMax(-t.shape).cwiseMin(t.shape);
  if (t.kind == Kind::kForceGain) return f;                 // the true force is smaller than its reading
  if (t.kind == Kind::kForceDelay) return -slope_of(f, h);  // the true force was there earlier
  for (Index k = 0; k < len; ++k) {
    const double angle = kTwoPi * t.shape * record.time_s(w.from + k);
    out[k] = t.kind == Kind::kForceHumCos50 ? std::cos(angle) : t.kind == Kind::kForceHumSin50 ? std::sin(angle) : 0;
  }
  return out;
}

bool Columns::of_channel(const Term& t, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
                         Vec& rows) const {
  const bool force = of_force_sensor(t.kind);
  if ((t.kind < Kind::kChannelDelay || t.kind > Kind::kHumSin) && !(massless_ && force)) return false;
  const Index len = w.length;
  const double step = records_[w.record].step_s;
  rows.setZero(static_cast<Index>(traces.size()) * len);
  for (size_t c = 0; c < traces.size(); ++c) {
    if (traces[c].dof != t.dof || traces[c].quantity != (force ? 3 : t.quantity)) continue;
    auto out = rows.segment(static_cast<Index>(c) * len, len);
    const Vec h = traces[c].y.segment(w.from, len) - run.residual.segment(static_cast<Index>(c) * len, len);
    if (t.kind == Kind::kChannelDelay || t.kind == Kind::kForceDelay)
      out = -slope_of(h, step);
    else if (t.kind == Kind::kChannelGain || t.kind == Kind::kForceGain)
      out = h;
    else
      for (Index k = 0; k < len; ++k) {
        const double angle = kTwoPi * t.shape * records_[w.record].time_s(w.from + k);
        out[k] = t.kind == Kind::kHumCos ? std::cos(angle) : std::sin(angle);
      }
  }
  return true;
}

void Columns::make(const std::vector<Term>& terms, const Window& w, const WindowRun& run,
                   const std::vector<MotionTrace>& traces, Mat& out) {
  const Index count = static_cast<Index>(terms.size()), len = w.length;
  const Index channels = static_cast<Index>(traces.size());
  if (memory_.size() != terms.size()) memory_.assign(terms.size(), {});
  out.setZero(count, channels * len);
  Mat g(count, len);
  std::vector<bool> direct(terms.size(), false);
  Index late = -1;  // the base's delay among the terms
  Mat late_base;
  Vec carried;
  for (Index i = 0; i < count; ++i) {
    Vec rows;
    const Term& t = terms[static_cast<size_t>(i)];
    if ((direct[static_cast<size_t>(i)] = of_channel(t, w, run, traces, rows))) {
      out.row(i) = rows, g.row(i).setZero();
      continue;
    }
    if (t.kind == Kind::kBaseDelay) {
      base_delay(w, run, late_base, carried), late = i, g.row(i).setZero();
      continue;
    }
    g.row(i) = force(t, w, run, memory_[static_cast<size_t>(i)]);
  }
  std::vector<std::pair<int, int>> ends(terms.size());
  for (size_t i = 0; i < terms.size(); ++i) {
    const Term& t = terms[i];
    ends[i] = t.link >= 0 ? std::make_pair(node_of(system_.links[static_cast<size_t>(t.link)].a),
                                           node_of(system_.links[static_cast<size_t>(t.link)].b))
                          : std::make_pair(t.dof, -1);
  }
  if (massless_) {
    for (size_t c = 0; c < traces.size(); ++c)
      for (Index i = 0; i < count; ++i) {
        if (direct[static_cast<size_t>(i)]) continue;
        const auto [a, b] = ends[static_cast<size_t>(i)];
        const double turn = a == traces[c].dof ? 1 : b == traces[c].dof ? -1 : 0;
        out.row(i).segment(static_cast<Index>(c) * len, len) = turn * g.row(i);
      }
    return;
  }
  const double half = 0.5 * records_[w.record].step_s;
  const Index n = run.x.rows(), ns = run.step.empty() ? 2 * n : run.step[0].rows();
  Mat d = Mat::Zero(count, ns), push(count, n), next(count, ns);  // one row per candidate
  const auto pushes = [&](Index k) {
    const Mat& yield = run.yield[static_cast<size_t>(k)];
    push.setZero();
    for (Index i = 0; i < count; ++i) {
      const auto [a, b] = ends[static_cast<size_t>(i)];
      const double f = g(i, k);
      if (f == 0) continue;
      for (Index node = 0; node < n; ++node) {  // a force moves its own node alone, unless links stick
        if (a >= 0 && yield(node, a) != 0) push(i, node) -= f * yield(node, a);
        if (b >= 0 && yield(node, b) != 0) push(i, node) += f * yield(node, b);
      }
    }
    if (late >= 0) push.row(late) = (yield * late_base.col(k)).transpose();
  };
  bool acceleration = false;
  for (const MotionTrace& t : traces) acceleration = acceleration || t.quantity == 2;
  Mat acc;
  for (Index k = 0; k < len; ++k) {
    pushes(k);
    if (k > 0) d.middleCols(n, n) += half * push;
    if (acceleration) {
      acc = push;
      add_outer_sums({d.data(), count, count}, {run.acc[static_cast<size_t>(k)].data(), n, n}, ns, acc.data());
    }
    if (acceleration && late >= 0) acc.row(late).array() += carried[k];
    for (Index c = 0; c < channels; ++c) {
      const MotionTrace& t = traces[static_cast<size_t>(c)];
      auto column = out.col(c * len + k);
      column += t.quantity == 0 ? d.col(t.dof) : t.quantity == 1 ? d.col(n + t.dof) : acc.col(t.dof);
    }
    if (k + 1 == len) break;
    d.middleCols(n, n) += half * push;
    next.setZero();
    add_outer_sums({d.data(), count, count}, {run.step[static_cast<size_t>(k)].data(), ns, ns}, ns, next.data());
    d.swap(next);
  }
}

}  // namespace diagnosis::runs
