#include <algorithm>
#include <cmath>

#include "simulator.hpp"

// Where a run begins, as the measured motion tells.
namespace diagnosis::runs {
namespace {

constexpr double kForgotten =
    5;  // of a bristle's length: what a link has moved since leaves 1 % of how it was bent before

}  // namespace

Vec Simulator::guessed_state(Index sample) const {
  Vec y = Vec::Zero(states());
  const Index dofs = static_cast<Index>(record_.guess.size()) - 1;
  for (Index i = 0; i < dofs; ++i) {
    const Guess& g = record_.guess[static_cast<size_t>(i)];
    y[i] = g.x[sample], y[nodes_ + i] = g.v[sample];
  }
  for (const Element& e : elements_) {
    if (e.kind == Kind::kResonance) y[e.b] = y[e.a], y[nodes_ + e.b] = y[nodes_ + e.a];
    if (e.kind == Kind::kPresliding) y[2 * nodes_ + e.z] = bent_so_far(e, sample);
  }
  return y;
}

// Of bristles, by the way that the link has gone: where the record begins they are bent as it moves there.
double Simulator::bent_so_far(const Element& e, Index sample) const {
  const auto end = [&](int node, Index k, bool rate) {
    const bool base = node == -2;
    if (node < 0 && !(base && record_.guess.back().given)) return 0.0;
    const Guess& g = base ? record_.guess.back() : record_.guess[static_cast<size_t>(node)];
    return rate ? g.v[k] : g.x[k];
  };
  const auto elongation = [&](Index k) { return end(e.a, k, false) - end(e.b, k, false); };
  Index from = sample;
  for (double way = 0; from > 0 && way < kForgotten * e.shape; --from)
    way += std::abs(elongation(from) - elongation(from - 1));
  double z = end(e.a, from, true) - end(e.b, from, true) < 0 ? -1 : 1;
  for (Index k = from + 1; k <= sample; ++k) z = bent_on(z, elongation(k) - elongation(k - 1), e.shape);
  return z;
}

}  // namespace diagnosis::runs
