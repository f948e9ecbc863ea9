// Forces of candidates with coefficient one, along the motion that a window's run has.
#include <algorithm>
#include <cmath>

#include "../readings/fault_shapes.hpp"
#include "columns.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLost = 0.25;  // of the square of a link's elongation about its mean: half of the elongation

// Whether a link's elongation holds the drift of a base whose displacement nobody measured.
bool drifts_with_base(const rig_file::Link& link, const Prepared& record) {
  const Base& base = record.base;
  return (link.a == rig_file::kBase || link.b == rig_file::kBase) && base.given() && !base.ridden &&
         base.reading[0].size() == 0;
}

// Does a simulation miss half of a link's elongation? What acts there acted along the measured one.
bool is_lost(const Vec& simulated, const Vec& measured) {
  double missed = 0, sum = 0, square = 0;
  for (Index k = 0; k < measured.size(); ++k) {
    const double u = measured[k], error = simulated[k] - u;
    missed += error * error, sum += u, square += u * u;
  }
  return missed > kLost * (square - sum * sum / static_cast<double>(measured.size()));
}

// Of a rate: between its two neighbours a sign is worth what they let it be.
double sign_at(const Vec& v, Index k) {
  const double spread = 0.25 * std::abs(v[std::min(v.size() - 1, k + 1)] - v[std::max<Index>(0, k - 1)]);
  return spread > 0 ? std::clamp(v[k] / spread, -1.0, 1.0) : v[k] < 0 ? -1.0 : 1.0;
}

// The force along a way of what remembers nothing.
double force_at(const Term& t, double u, double v, Index sample, const Prepared& record) {
  const double force = law(t.kind, u, v, law_time(record.time_s(sample), t.shape, record), t.shape, t.shape2).force;
  const bool pulsates = (t.kind == Kind::kStiffnessError || t.kind == Kind::kMissingViscous) && t.shape > 0;  // Hz
  return pulsates ? force * std::cos(kTwoPi * t.shape * record.time_s(sample) + t.shape2) : force;
}

}  // namespace

Columns::Way Columns::outer_way(int end, const Window& w) const {
  const Guess& g = records_[w.record].guess.back();
  if (end != rig_file::kBase || !g.given) return {Vec::Zero(w.length), Vec::Zero(w.length)};
  return {g.x.segment(w.from, w.length), g.v.segment(w.from, w.length)};
}

Columns::Way Columns::simulated_way(int end, const Window& w, const WindowRun& run) const {
  if (end <= 0) return outer_way(end, w);
  return {run.x.row(end - 1), run.v.row(end - 1)};
}

Columns::Way Columns::measured_way(int end, const Window& w) const {
  if (end <= 0) return outer_way(end, w);
  const Guess& g = records_[w.record].guess[static_cast<size_t>(end - 1)];
  return {g.x.segment(w.from, w.length), g.v.segment(w.from, w.length)};
}

bool Columns::has_coulomb(int link) const {
  return std::any_of(model_.begin(), model_.end(), [&](const ModelTerm& m) {
    return m.term.link == link && (m.term.kind == Kind::kCoulomb || m.term.kind == Kind::kMissingCoulomb);
  });
}

Vec Columns::link_force(const Term& t, const Window& w, const WindowRun& run, bool follows, Memory& memory) const {
  const rig_file::Link& l = system_.links[static_cast<size_t>(t.link)];
  const Prepared& record = records_[w.record];
  const Way simulated = simulated_way(l.a, w, run).less(simulated_way(l.b, w, run));
  const Way measured = measured_way(l.a, w).less(measured_way(l.b, w));
  // of what drifts the rate tells: a drift is slow
  const bool lost = drifts_with_base(l, record) ? is_lost(simulated.v, measured.v) : is_lost(simulated.u, measured.u);
  const Way& along = lost ? measured : simulated;
  if (t.kind == Kind::kPresliding) return bristle_force(t, along, follows, memory);
  Vec out(w.length);
  for (Index k = 0; k < w.length; ++k) {
    if (t.kind == Kind::kMissingCoulomb)
      out[k] = sign_at(along.v, k);
    else if (t.kind == Kind::kStribeck)
      out[k] = sign_at(along.v, k) * std::exp(-std::abs(along.v[k]) / t.shape);
    else if (t.kind == Kind::kCogging)  // finer than what a simulation without it hits: along the way as measured
      out[k] = law(t.kind, measured.u[k], along.v[k], 0, t.shape, t.shape2).force;
    else
      out[k] = force_at(t, along.u[k], along.v[k], w.from + k, record);
  }
  return out;
}

// They take the place of the friction that the model has there.
Vec Columns::bristle_force(const Term& t, const Way& along, bool follows, Memory& memory) const {
  const bool replaces = has_coulomb(t.link);
  if (!follows) memory.z = along.v[0] < 0 ? -1 : 1;
  Vec out(along.u.size());
  for (Index k = 0; k < out.size(); ++k) {
    if (k > 0) memory.z = bent_on(memory.z, along.u[k] - along.u[k - 1], t.shape);
    out[k] = memory.z - (replaces ? sign_at(along.v, k) : 0);
  }
  return out;
}

// Newmark, average acceleration.
Vec Columns::resonance_force(const Term& t, const Window& w, const WindowRun& run, bool follows, Memory& memory) const {
  const Prepared& record = records_[w.record];
  const Index d = t.dof, len = w.length;
  const double h = record.step_s, o = kTwoPi * t.shape, c = 2 * t.shape2 * o, q = o * o,
               yield = 1 / (1 + 0.5 * h * c + 0.25 * h * h * q);
  if (!follows) memory.z = run.x(d, 0), memory.v = run.v(d, 0);
  const auto carried = [&](Index k) { return record.base.ridden ? record.guess.back().a[w.from + k] : 0.0; };
  // a: against the ground; z and s: against the base where that carries the rig
  double z = memory.z, s = memory.v, a = c * (run.v(d, 0) - s) + q * (run.x(d, 0) - z);
  Vec out(len);
  for (Index k = 0; k < len; ++k) {
    out[k] = a;
    const Index n = std::min(len - 1, k + 1);
    const double now = a - carried(k), lost = carried(n);
    const double zp = z + h * s + 0.25 * h * h * (now - lost), sp = s + 0.5 * h * (now - lost);
    const double next = (c * (run.v(d, n) - sp) + q * (run.x(d, n) - zp)) * yield;
    z = zp + 0.25 * h * h * next, s = sp + 0.5 * h * next, a = next;
  }
  memory.z = z, memory.v = s;
  return out;
}

Vec Columns::drive_fault(const Term& t, const Window& w) const {
  const Prepared& record = records_[w.record];
  const Vec f = record.force[static_cast<size_t>(t.dof)].segment(w.from, w.length);
  switch (t.kind) {
    case Kind::kDeadBand:
      return f.cwiseMax(-t.shape).cwiseMin(t.shape);
    case Kind::kForceGain:  // the true force is smaller than its reading
      return f;
    case Kind::kForceDelay:  // the true force was there earlier
      return -slope_in_time(f, record.step_s);
    case Kind::kForceHumCos50:
    case Kind::kForceHumSin50:
      return hum_wave(record, w.from, w.length, t.shape, t.kind == Kind::kForceHumCos50);
    default:
      return Vec::Zero(w.length);
  }
}

Vec Columns::force(const Term& t, const Window& w, const WindowRun& run, Memory& memory) const {
  if (t.kind == Kind::kMassError && t.link < 0) return run.a.row(t.dof);
  if (t.link < 0 && t.kind != Kind::kResonance) return drive_fault(t, w);
  const bool follows = memory.ends == w.from && memory.record == w.record;
  memory.ends = w.from + w.length, memory.record = w.record;
  return t.link >= 0 ? link_force(t, w, run, follows, memory) : resonance_force(t, w, run, follows, memory);
}

}  // namespace diagnosis::runs
