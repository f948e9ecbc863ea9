#include "evaluator.hpp"

#include <cmath>

#include "host_sim/vocabulary/held_in_place.hpp"
#include "in_parallel.hpp"
#include "rounding.hpp"

namespace diagnosis::runs {
namespace {

constexpr int kForceTrace = 3;

bool of_channel(const ModelTerm& t, const MotionTrace& trace) {
  const int quantity = of_force_sensor(t.term.kind) ? kForceTrace : t.term.quantity;
  return t.term.dof == trace.dof && quantity == trace.quantity;
}

// Slope in time of a row, five points inside, fewer at the ends.
Vec slope_of(const Vec& h, double step_s) {
  const Index n = h.size();
  Vec out(n);
  for (Index i = 0; i < n; ++i) {
    if (i >= 2 && i + 2 < n)
      out[i] = (8 * (h[i + 1] - h[i - 1]) - (h[i + 2] - h[i - 2])) / (12 * step_s);
    else {
      const Index a = std::max<Index>(0, i - 1), b = std::min(n - 1, i + 1);
      out[i] = (h[b] - h[a]) / (static_cast<double>(b - a) * step_s);
    }
  }
  return out;
}

}  // namespace

Evaluator::Evaluator(const System& system, const Model& model, const std::vector<Prepared>& records)
    : system_(system),
      model_(model),
      records_(records),
      held_(vocabulary::held_in_place(system.rig)),
      dofs_(static_cast<Index>(system.dofs())) {
  of_lanes_.resize(lanes() - 1);
  for (Simulators& of_lane : of_lanes_) of_lane.resize(records.size());
  for (const Prepared& p : records) {
    driven_ = driven_ || p.guess.back().given;
    for (const Vec& f : p.force) driven_ = driven_ || (f.size() > 0 && f.cwiseAbs().maxCoeff() > 0);
  }
  for (const Prepared& p : records) {
    simulators_.push_back(std::make_unique<Simulator>(system, model, p));
    const Simulator& s = *simulators_.back();
    parameters_ = s.parameters();
    massless_ = s.massless();
    sound_ = sound_ && (massless_ || s.sound());
    if (!massless_) continue;
    force_traces_.push_back({});
    const Index n = static_cast<Index>(system.dofs());
    Mat x(n, p.samples), v(n, p.samples), a(n, p.samples);
    for (Index d = 0; d < n; ++d) {
      const Guess& g = p.guess[static_cast<size_t>(d)];
      x.row(d) = g.x, v.row(d) = g.v, a.row(d) = g.a;
      if (p.force[static_cast<size_t>(d)].size())
        force_traces_.back().push_back({static_cast<int>(d), kForceTrace, "", p.force[static_cast<size_t>(d)]});
    }
    forces_.push_back({});
    s.forces_of_motion(x, v, a, forces_.back().force, forces_.back().slopes);
  }
  if (massless_)
    for (const auto& list : force_traces_)
      if (list.empty()) throw CannotAnswer("no mass and no force channel: nothing balances the links' forces");
}

Vec Evaluator::carried_state(const Window& w) const {
  if (massless_) return Vec();
  const Simulator& s = *simulators_[w.record];
  Index offsets = 0;
  for (const MotionTrace& t : traces(w.record)) offsets += has_offset(t);
  Vec state = Vec::Zero(s.states() + offsets);
  if (w.state.size() == state.size()) return w.state;
  state.head(s.states()) = s.guessed_state(w.from);
  if (w.state.size() >= 2 * dofs_ + offsets && w.state.size() < state.size()) {  // the DOFs keep what they had
    const Index nodes = w.state.size() == 2 * dofs_ + offsets ? dofs_ : 0;
    if (nodes) state.head(dofs_) = w.state.head(dofs_), state.segment(s.nodes(), dofs_) = w.state.segment(dofs_, dofs_);
    state.tail(offsets) = w.state.tail(offsets);
  }
  return state;
}

void Evaluator::moved(const Window& w, const Vec& change, Vec& state) const {
  state += change.head(state.size());
  const Simulator& s = *simulators_[w.record];
  for (Index z = 2 * s.nodes(); z < s.states(); ++z) state[z] = std::min(1.0, std::max(-1.0, state[z]));
}

Simulator& Evaluator::simulator(size_t record, size_t lane) {
  if (lane == 0) return *simulators_[record];
  std::unique_ptr<Simulator>& own = of_lanes_[lane - 1][record];
  if (!own) own = std::make_unique<Simulator>(system_, model_, records_[record]);
  return *own;
}

bool Evaluator::run(const Window& w, bool slopes, bool keep, WindowRun& out, size_t lane) {
  if (massless_) {
    from_motion(w, slopes, out);
    return out.residual.allFinite();
  }
  return simulate(simulator(w.record, lane), w, slopes, keep, out);
}

void Evaluator::from_motion(const Window& w, bool slopes, WindowRun& out) const {
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  const MotionForces& f = forces_[w.record];
  const Index channels = static_cast<Index>(channel_list.size()), len = w.length;
  Mat h(channels, len);
  out.nuisances = 0;
  if (slopes) out.slopes.setZero(channels * len, parameters_);
  for (Index c = 0; c < channels; ++c) {
    const int d = channel_list[static_cast<size_t>(c)].dof;
    h.row(c) = f.force.row(d).segment(w.from, len);
    if (slopes)
      for (Index p = 0; p < parameters_; ++p)
        out.slopes.col(p).segment(c * len, len) =
            f.slopes[static_cast<size_t>(p)].row(d).segment(w.from, len).transpose();
  }
  const Prepared& record = records_[w.record];
  const Index n = static_cast<Index>(record.guess.size()) - 1;
  out.x.resize(n, len), out.v.resize(n, len), out.a.resize(n, len);
  for (Index d = 0; d < n; ++d) {
    const Guess& g = record.guess[static_cast<size_t>(d)];
    out.x.row(d) = g.x.segment(w.from, len), out.v.row(d) = g.v.segment(w.from, len),
    out.a.row(d) = g.a.segment(w.from, len);
  }
  faults(w, slopes, h, out);
}

bool Evaluator::simulate(Simulator& s, const Window& w, bool slopes, bool keep, WindowRun& out) const {
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  const Index channels = static_cast<Index>(channel_list.size()), len = w.length, ns = s.states(), n = s.nodes();
  bool acceleration = false;
  Index offsets = 0;
  for (const MotionTrace& t : channel_list) acceleration = acceleration || t.quantity == 2, offsets += has_offset(t);
  out.nuisances = ns + offsets;
  Vec y = w.state.head(ns), acc;
  Sensitivity one, start = Sensitivity::Zero(ns, ns + parameters_);
  start.leftCols(ns).setIdentity();
  Sensitivity sensitivity = start;
  Mat acc_slopes;
  Mat h(channels, len);
  if (slopes) out.slopes.resize(channels * len, out.nuisances + parameters_);
  out.x.resize(n, len), out.v.resize(n, len), out.a.resize(n, len);
  if (keep)
    out.step.resize(static_cast<size_t>(len)), out.acc.resize(static_cast<size_t>(len)),
        out.yield.resize(static_cast<size_t>(len));
  s.start(w.from, y);
  const bool slopes_of_acc = slopes && (acceleration || keep || !s.affine());
  for (Index k = 0; k < len; ++k) {
    s.accelerations(w.from + k, y, acc, slopes_of_acc ? &acc_slopes : nullptr);
    out.x.col(k) = y.head(n), out.v.col(k) = y.segment(n, n), out.a.col(k) = acc;
    if (keep) out.acc[static_cast<size_t>(k)] = acc_slopes.leftCols(ns), out.yield[static_cast<size_t>(k)] = s.yield();
    Index offset = ns;
    const Sensitivity* const acc_rows =
        slopes && acceleration ? &s.rows_of_accelerations(acc_slopes, sensitivity) : nullptr;
    for (Index c = 0; c < channels; ++c) {
      const MotionTrace& t = channel_list[static_cast<size_t>(c)];
      h(c, k) = t.quantity == 0 ? y[t.dof] : t.quantity == 1 ? y[n + t.dof] : acc[t.dof];
      const Index own = offset;
      if (has_offset(t)) h(c, k) += w.state[offset++];
      if (!slopes) continue;
      auto row = out.slopes.row(c * len + k);
      const Sensitivity& rows = t.quantity == 2 ? *acc_rows : sensitivity;
      const auto from = rows.row(t.quantity == 1 ? n + t.dof : t.dof);
      row.head(ns) = from.head(ns), row.tail(parameters_) = from.tail(parameters_);
      row.segment(ns, offsets).setZero();
      if (has_offset(t)) row[own] = 1;
    }
    if (k + 1 == len) break;
    if (!keep) {
      if (!s.advance(w.from + k, y, slopes ? &sensitivity : nullptr)) return false;
      continue;
    }
    one = start;
    if (!s.advance(w.from + k, y, &one)) return false;
    out.step[static_cast<size_t>(k)] = one.leftCols(ns);
    Sensitivity next = one.leftCols(ns) * sensitivity;
    next.rightCols(parameters_) += one.rightCols(parameters_);
    sensitivity.swap(next);
  }
  out.end.resize(0);
  if (!slopes && w.from + len < records_[w.record].samples && s.advance(w.from + len - 1, y, nullptr))
    out.end = w.state, out.end.head(ns) = y;
  round_jumps(w, slopes, h, out);
  faults(w, slopes, h, out);
  return out.residual.allFinite() &&
         (!slopes || sensitivity.allFinite());  // what was not finite once is not at the end
}

// Jumps of accelerations as they are read.
void Evaluator::round_jumps(const Window& w, bool slopes, Mat& h, WindowRun& out) const {
  const Rounding rounding(records_[w.record].rounded_over);
  if (!rounding.any()) return;
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  for (Index c = 0; c < h.rows(); ++c) {
    if (channel_list[static_cast<size_t>(c)].quantity != 2) continue;
    h.row(c) = rounding.of(h.row(c).transpose());
    for (Index p = 0; slopes && p < out.slopes.cols(); ++p) {
      auto slope = out.slopes.col(p).segment(c * w.length, w.length);
      slope = rounding.of(slope);
    }
  }
}

// What the sensors make of it; then the residual.
void Evaluator::faults(const Window& w, bool slopes, Mat& h, WindowRun& out) const {
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  const Prepared& record = records_[w.record];
  const Index len = w.length, channels = h.rows();
  const std::vector<Parameter> parameters = parameters_of(model_);
  const auto column = [&](size_t term) {
    for (size_t p = 0; p < parameters.size(); ++p)
      if (parameters[p].term == term) return out.nuisances + static_cast<Index>(p);
    return Index{-1};
  };
  out.residual.resize(channels * len);
  for (Index c = 0; c < channels; ++c) {
    const MotionTrace& trace = channel_list[static_cast<size_t>(c)];
    const Vec clean = h.row(c);
    Vec reading = clean;
    for (size_t i = 0; i < model_.size(); ++i) {
      const ModelTerm& t = model_[i];
      const Kind kind = t.term.kind;
      if (kind < Kind::kForceDelay || kind > Kind::kHumSin || !of_channel(t, trace)) continue;
      Vec unit;
      const double at = t.value;
      if (kind == Kind::kChannelDelay || kind == Kind::kForceDelay) {
        unit = -slope_of(clean, record.step_s);
        reading += at * unit - 0.5 * at * at * slope_of(unit, record.step_s);
        unit -= at * slope_of(unit, record.step_s);
      } else {
        if (kind == Kind::kChannelGain || kind == Kind::kForceGain) unit = clean;
        if (kind == Kind::kHumCos || kind == Kind::kHumSin) {
          unit.resize(len);
          for (Index k = 0; k < len; ++k) {
            const double angle = kTwoPi * t.term.shape * record.time_s(w.from + k);
            unit[k] = kind == Kind::kHumCos ? std::cos(angle) : std::sin(angle);
          }
        }
        if (unit.size() == 0) continue;
        reading += at * unit;
      }
      const Index p = column(i);
      if (slopes && p >= 0) out.slopes.col(p).segment(c * len, len) += unit;
    }
    out.residual.segment(c * len, len) = trace.y.segment(w.from, len) - reading;
  }
}

}  // namespace diagnosis::runs
