// Models ready to run, and the forces of those that have no mass.
#include "evaluator.hpp"

#include "host_sim/vocabulary/held_in_place.hpp"
#include "in_parallel.hpp"
#include "reversals.hpp"

namespace diagnosis::runs {

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
    if (massless_) take_forces(s, p);
  }
  for (const auto& list : force_traces_)
    if (list.empty()) throw CannotAnswer("no mass and no force channel: nothing balances the links' forces");
}

void Evaluator::take_forces(const Simulator& s, const Prepared& p) {
  Mat x(dofs_, p.samples), v(dofs_, p.samples), a(dofs_, p.samples);
  std::vector<MotionTrace> traces;
  for (Index d = 0; d < dofs_; ++d) {
    const Guess& g = p.guess[static_cast<size_t>(d)];
    const Vec& force = p.force[static_cast<size_t>(d)];
    x.row(d) = g.x, v.row(d) = g.v, a.row(d) = g.a;
    if (force.size()) traces.push_back({static_cast<int>(d), kForceTrace, "", force});
  }
  force_traces_.push_back(traces);
  forces_.push_back({});
  s.forces_of_motion(x, v, a, forces_.back().force, forces_.back().slopes);
  forces_.back().counted = directions_known(system_, p);
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
  for (Index c = 0; c < channels; ++c) {
    const auto counted = counted_of(w, c);
    out.residual.segment(c * len, len).array() *= counted.array();
    if (slopes) out.slopes.middleRows(c * len, len).array().colwise() *= counted.array();
  }
}

Vec Evaluator::counted_of(const Window& w, Index channel) const {
  const int dof = traces(w.record)[static_cast<size_t>(channel)].dof;
  return forces_[w.record].counted.row(dof).segment(w.from, w.length).transpose();
}

void Evaluator::leave_out_reversals(const Window& w, Mat& columns) const {
  if (!massless_) return;
  for (Index c = 0; c * w.length < columns.cols(); ++c)
    columns.middleCols(c * w.length, w.length).array().rowwise() *= counted_of(w, c).transpose().array();
}

}  // namespace diagnosis::runs
