// A window's free run: its channels as the simulator has them, and how they answer to states and parameters.
#include "evaluator.hpp"

namespace diagnosis::runs {
namespace {

// Columns of the slopes, in their order.
struct Sizes {
  Index states = 0, offsets = 0, parameters = 0;
};

void resize(WindowRun& out, Index samples, Index channels, Index nodes, const Sizes& sizes, bool slopes, bool keep) {
  out.nuisances = sizes.states + sizes.offsets;
  out.x.resize(nodes, samples), out.v.resize(nodes, samples), out.a.resize(nodes, samples);
  if (slopes) out.slopes.resize(channels * samples, out.nuisances + sizes.parameters);
  if (!keep) return;
  const size_t count = static_cast<size_t>(samples);
  out.step.resize(count), out.acc.resize(count), out.yield.resize(count);
}

// From sample to sample.
class FreeRun {
 public:
  FreeRun(Simulator& s, const Window& w, const Sizes& sizes, bool slopes, bool keep, WindowRun& out)
      : s_(s), w_(w), sizes_(sizes), slopes_(slopes), keep_(keep), out_(out), y_(w.state.head(sizes.states)) {
    start_ = Sensitivity::Zero(sizes.states, sizes.states + sizes.parameters);
    start_.leftCols(sizes.states).setIdentity();
    sensitivity_ = start_;
    s_.start(w.from, y_);
  }

  void accelerate(Index k, bool slopes) {
    const Index n = s_.nodes();
    s_.accelerations(w_.from + k, y_, acc_, slopes ? &acc_slopes_ : nullptr);
    out_.x.col(k) = y_.head(n), out_.v.col(k) = y_.segment(n, n), out_.a.col(k) = acc_;
    if (!keep_) return;
    out_.acc[static_cast<size_t>(k)] = acc_slopes_.leftCols(sizes_.states);
    out_.yield[static_cast<size_t>(k)] = s_.yield();
  }

  double reading(const MotionTrace& t) const {
    return t.quantity == 0 ? y_[t.dof] : t.quantity == 1 ? y_[s_.nodes() + t.dof] : acc_[t.dof];
  }

  const Sensitivity& rows_of_accelerations() { return s_.rows_of_accelerations(acc_slopes_, sensitivity_); }

  // accelerations: their rows, for a channel that reads one.
  void take_slopes(const MotionTrace& t, const Sensitivity* accelerations, Index at) {
    auto row = out_.slopes.row(at);
    const Sensitivity& rows = t.quantity == 2 ? *accelerations : sensitivity_;
    const auto from = rows.row(t.quantity == 1 ? s_.nodes() + t.dof : t.dof);
    row.head(sizes_.states) = from.head(sizes_.states), row.tail(sizes_.parameters) = from.tail(sizes_.parameters);
    row.segment(sizes_.states, sizes_.offsets).setZero();
  }

  // False where the state does not stay finite.
  bool advance(Index k) {
    if (!keep_) return s_.advance(w_.from + k, y_, slopes_ ? &sensitivity_ : nullptr);
    one_ = start_;
    if (!s_.advance(w_.from + k, y_, &one_)) return false;
    out_.step[static_cast<size_t>(k)] = one_.leftCols(sizes_.states);
    Sensitivity next = one_.leftCols(sizes_.states) * sensitivity_;
    next.rightCols(sizes_.parameters) += one_.rightCols(sizes_.parameters);
    sensitivity_.swap(next);
    return true;
  }

  // One sample beyond the window, where the record has one.
  void take_end(Index samples_of_record) {
    out_.end.resize(0);
    const Index last = w_.from + w_.length - 1;
    if (!slopes_ && last + 1 < samples_of_record && s_.advance(last, y_, nullptr))
      out_.end = w_.state, out_.end.head(sizes_.states) = y_;
  }

  // What was not finite once is not at the end.
  bool finite() const { return out_.residual.allFinite() && (!slopes_ || sensitivity_.allFinite()); }

 private:
  Simulator& s_;
  const Window& w_;
  const Sizes sizes_;
  const bool slopes_, keep_;
  WindowRun& out_;
  Vec y_, acc_;
  Mat acc_slopes_;
  Sensitivity sensitivity_;  // of y_, to the state at the window's start and to the parameters
  Sensitivity start_, one_;  // that of a step alone
};

}  // namespace

bool Evaluator::simulate(Simulator& s, const Window& w, bool slopes, bool keep, WindowRun& out) const {
  const std::vector<MotionTrace>& channel_list = traces(w.record);
  const Index channels = static_cast<Index>(channel_list.size()), len = w.length;
  bool acceleration = false;
  Sizes sizes{s.states(), 0, parameters_};
  for (const MotionTrace& t : channel_list)
    acceleration = acceleration || t.quantity == 2, sizes.offsets += has_offset(t);
  resize(out, len, channels, s.nodes(), sizes, slopes, keep);
  Mat h(channels, len);
  FreeRun run(s, w, sizes, slopes, keep, out);
  const bool slopes_of_acc = slopes && (acceleration || keep || !s.affine());
  for (Index k = 0; k < len; ++k) {
    run.accelerate(k, slopes_of_acc);
    const Sensitivity* const acc_rows = slopes && acceleration ? &run.rows_of_accelerations() : nullptr;
    Index offset = sizes.states;
    for (Index c = 0; c < channels; ++c) {
      const MotionTrace& t = channel_list[static_cast<size_t>(c)];
      h(c, k) = run.reading(t);
      if (slopes) run.take_slopes(t, acc_rows, c * len + k);
      if (!has_offset(t)) continue;
      h(c, k) += w.state[offset];
      if (slopes) out.slopes(c * len + k, offset) = 1;
      ++offset;
    }
    if (k + 1 < len && !run.advance(k)) return false;
  }
  run.take_end(records_[w.record].samples);
  round_jumps(w, slopes, h, out);
  faults(w, slopes, h, out);
  return run.finite();
}

}  // namespace diagnosis::runs
