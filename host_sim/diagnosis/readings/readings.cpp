// What the sensors make of a window's simulated channels.
#include "../fit/evaluator.hpp"
#include "fault_shapes.hpp"
#include "rounding.hpp"

namespace diagnosis::runs {
namespace {

bool of_channel(const ModelTerm& t, const MotionTrace& trace) {
  const int quantity = of_force_sensor(t.term.kind) ? kForceTrace : t.term.quantity;
  return t.term.dof == trace.dof && quantity == trace.quantity;
}

bool is_fault(const ModelTerm& t, const MotionTrace& trace) {
  return t.term.kind >= Kind::kForceDelay && t.term.kind <= Kind::kHumSin && of_channel(t, trace);
}

// Adds what a fault makes of a clean reading; how that answers to its coefficient, or nothing where it is none of a reading.
Vec add_fault(const ModelTerm& t, const Vec& clean, const Prepared& record, Index from, Vec& reading) {
  const double at = t.value;
  switch (t.term.kind) {
    case Kind::kChannelDelay:
    case Kind::kForceDelay: {  // to the second order
      const Vec slope = -slope_in_time(clean, record.step_s), bend = slope_in_time(slope, record.step_s);
      reading += at * slope - 0.5 * at * at * bend;
      return slope - at * bend;
    }
    case Kind::kChannelGain:
    case Kind::kForceGain:
      reading += at * clean;
      return clean;
    case Kind::kHumCos:
    case Kind::kHumSin: {
      const Vec hum = hum_wave(record, from, clean.size(), t.term.shape, t.term.kind == Kind::kHumCos);
      reading += at * hum;
      return hum;
    }
    default:
      return {};
  }
}

}  // namespace

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

Index Evaluator::parameter_of(size_t term) const {
  const std::vector<Parameter> parameters = parameters_of(model_);
  for (size_t p = 0; p < parameters.size(); ++p)
    if (parameters[p].term == term) return static_cast<Index>(p);
  return -1;
}

// Then the residual.
void Evaluator::faults(const Window& w, bool slopes, Mat& h, WindowRun& out) const {
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  const Index len = w.length;
  out.residual.resize(h.rows() * len);
  for (Index c = 0; c < h.rows(); ++c) {
    const MotionTrace& trace = channel_list[static_cast<size_t>(c)];
    const Vec clean = h.row(c);
    Vec reading = clean;
    for (size_t i = 0; i < model_.size(); ++i) {
      if (!is_fault(model_[i], trace)) continue;
      const Vec by_value = add_fault(model_[i], clean, records_[w.record], w.from, reading);
      const Index p = slopes && by_value.size() ? parameter_of(i) : -1;
      if (p >= 0) out.slopes.col(out.nuisances + p).segment(c * len, len) += by_value;
    }
    out.residual.segment(c * len, len) = trace.y.segment(w.from, len) - reading;
  }
}

}  // namespace diagnosis::runs
