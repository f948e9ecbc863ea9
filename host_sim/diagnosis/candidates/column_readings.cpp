// Columns of sensors' faults: those of a channel's own reading, and the delay of the base's channels.
#include "../readings/fault_shapes.hpp"
#include "columns.hpp"

namespace diagnosis::runs {

bool Columns::of_channel(const Term& t, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
                         Vec& rows) const {
  const bool force = of_force_sensor(t.kind);
  if ((t.kind < Kind::kChannelDelay || t.kind > Kind::kHumSin) && !(massless_ && force)) return false;
  const Index len = w.length;
  const Prepared& record = records_[w.record];
  rows.setZero(static_cast<Index>(traces.size()) * len);
  for (size_t c = 0; c < traces.size(); ++c) {
    if (traces[c].dof != t.dof || traces[c].quantity != (force ? kForceTrace : t.quantity)) continue;
    auto out = rows.segment(static_cast<Index>(c) * len, len);
    const Vec simulated = traces[c].y.segment(w.from, len) - run.residual.segment(static_cast<Index>(c) * len, len);
    if (t.kind == Kind::kChannelDelay || t.kind == Kind::kForceDelay)
      out = -slope_in_time(simulated, record.step_s);
    else if (t.kind == Kind::kChannelGain || t.kind == Kind::kForceGain)
      out = simulated;
    else
      out = hum_wave(record, w.from, len, t.shape, t.kind == Kind::kHumCos);
  }
  return true;
}

double Columns::base(const Window& w, Index k, bool rate) const {
  const Guess& g = records_[w.record].guess.back();
  return g.given ? (rate ? g.v : g.x)[w.from + k] : 0;
}

void Columns::base_delay(const Window& w, const WindowRun& run, Mat& forces, Vec& carried) const {
  const Prepared& record = records_[w.record];
  const Guess& g = record.guess.back();
  forces.setZero(run.x.rows(), w.length), carried.setZero(w.length);
  if (record.base.ridden) {
    carried = slope_in_time(g.a, record.step_s).segment(w.from, w.length);
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

}  // namespace diagnosis::runs
