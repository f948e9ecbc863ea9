// Columns of candidates, carried along a window by the transitions that its run kept.
#include "columns.hpp"

#include "../fit/outer_sums.hpp"

namespace diagnosis::runs {

struct Columns::Acting {
  Mat force;                 // terms x samples, on the first node and against the second
  std::vector<Place> nodes;  // of each term
  std::vector<bool> direct;  // terms whose rows are made already
  Index late = -1;           // the base's delay among the terms
  Mat late_base;             // its forces, nodes x samples
  Vec carried;               // its acceleration of the base

  // What the terms push the nodes with at a sample, as accelerations: one row per term.
  void push(Index sample, const Mat& yield, Mat& out) const {
    out.setZero();
    for (Index i = 0; i < out.rows(); ++i) {
      const auto [a, b] = nodes[static_cast<size_t>(i)];
      const double f = force(i, sample);
      if (f == 0) continue;
      for (Index node = 0; node < out.cols(); ++node) {  // a force moves its own node alone, unless links stick
        if (a >= 0 && yield(node, a) != 0) out(i, node) -= f * yield(node, a);
        if (b >= 0 && yield(node, b) != 0) out(i, node) += f * yield(node, b);
      }
    }
    if (late >= 0) out.row(late) = (yield * late_base.col(sample)).transpose();
  }
};

Columns::Acting Columns::acting(const std::vector<Term>& terms, const Window& w, const WindowRun& run,
                                const std::vector<MotionTrace>& traces, Mat& out) {
  if (memory_.size() != terms.size()) memory_.assign(terms.size(), {});
  Acting all;
  all.force.resize(static_cast<Index>(terms.size()), w.length);
  Vec rows;
  for (size_t i = 0; i < terms.size(); ++i) {
    const Index row = static_cast<Index>(i);
    all.nodes.push_back(place_of_force(system_, terms[i]));
    all.direct.push_back(of_channel(terms[i], w, run, traces, rows));
    if (all.direct[i])
      out.row(row) = rows, all.force.row(row).setZero();
    else if (terms[i].kind == Kind::kBaseDelay)
      base_delay(w, run, all.late_base, all.carried), all.late = row, all.force.row(row).setZero();
    else
      all.force.row(row) = force(terms[i], w, run, memory_[i]);
  }
  return all;
}

// Without masses a channel reads the forces on its DOF.
void Columns::balance(const Acting& acting, const Window& w, const std::vector<MotionTrace>& traces, Mat& out) const {
  for (size_t c = 0; c < traces.size(); ++c)
    for (Index i = 0; i < out.rows(); ++i) {
      if (acting.direct[static_cast<size_t>(i)]) continue;
      const auto [a, b] = acting.nodes[static_cast<size_t>(i)];
      const double turn = a == traces[c].dof ? 1 : b == traces[c].dof ? -1 : 0;
      out.row(i).segment(static_cast<Index>(c) * w.length, w.length) = turn * acting.force.row(i);
    }
}

// A force acts half on this step and half on the next.
void Columns::carry(const Acting& acting, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
                    Mat& out) const {
  const Index count = out.rows(), len = w.length;
  const double half = 0.5 * records_[w.record].step_s;
  const Index n = run.x.rows(), ns = run.step.empty() ? 2 * n : run.step[0].rows();
  Mat d = Mat::Zero(count, ns), push(count, n), next(count, ns), acc;  // one row per candidate
  bool acceleration = false;
  for (const MotionTrace& t : traces) acceleration = acceleration || t.quantity == 2;
  for (Index k = 0; k < len; ++k) {
    const size_t at = static_cast<size_t>(k);
    acting.push(k, run.yield[at], push);
    if (k > 0) d.middleCols(n, n) += half * push;
    if (acceleration) {
      acc = push;
      add_outer_sums({d.data(), count, count}, {run.acc[at].data(), n, n}, ns, acc.data());
      if (acting.late >= 0) acc.row(acting.late).array() += acting.carried[k];
    }
    for (size_t c = 0; c < traces.size(); ++c) {
      const MotionTrace& t = traces[c];
      auto column = out.col(static_cast<Index>(c) * len + k);
      column += t.quantity == 0 ? d.col(t.dof) : t.quantity == 1 ? d.col(n + t.dof) : acc.col(t.dof);
    }
    if (k + 1 == len) break;
    d.middleCols(n, n) += half * push;
    next.setZero();
    add_outer_sums({d.data(), count, count}, {run.step[at].data(), ns, ns}, ns, next.data());
    d.swap(next);
  }
}

void Columns::make(const std::vector<Term>& terms, const Window& w, const WindowRun& run,
                   const std::vector<MotionTrace>& traces, Mat& out) {
  out.setZero(static_cast<Index>(terms.size()), static_cast<Index>(traces.size()) * w.length);
  const Acting all = acting(terms, w, run, traces, out);
  if (massless_)
    balance(all, w, traces, out);
  else
    carry(all, w, run, traces, out);
}

}  // namespace diagnosis::runs
