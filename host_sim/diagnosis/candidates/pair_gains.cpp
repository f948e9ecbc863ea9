// Two at a time, in closed form, from one pass over the windows.
#include "pair_gains.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kDistinct = 1e-4;  // of the product of two columns' squares: what is nearly one cause is no pair

// Normal equations of the columns beside the model, with its numbers free to give way.
struct Equations {
  Mat gram;
  Vec right;
};

Equations equations_of(Pass& pass, const std::vector<Term>& terms, const Gains& gains) {
  const Index n = static_cast<Index>(terms.size());
  Equations e{Mat::Zero(n, n), Vec::Zero(n)};
  Mat with_model = Mat::Zero(n, gains.score().size());
  pass.over(terms, [&](size_t, const Mat& c, const Sensitivity& slopes, const Vec& residual) {
    e.gram.noalias() += c * c.transpose(), with_model.noalias() += c * slopes, e.right.noalias() += c * residual;
  });
  e.gram -= with_model * gains.inverse() * with_model.transpose();
  e.right -= with_model * gains.inverse() * gains.score();
  return e;
}

}  // namespace

std::vector<ScreenedPair> pair_gains(const System& system, const std::vector<Prepared>& records, const Model& model,
                                     const std::vector<Window>& windows, const Fitted& fit,
                                     const std::vector<Candidate>& candidates, const std::vector<size_t>& chosen,
                                     const Gains& gains, double residual_square) {
  std::vector<Term> terms;
  for (size_t c : chosen) terms.push_back(candidates[c].terms[0]);
  Pass pass(system, records, model, windows, fit);
  const Equations e = equations_of(pass, terms, gains);
  std::vector<ScreenedPair> pairs;
  for (Index i = 0; i < e.right.size(); ++i)
    for (Index j = 0; j < i; ++j) {
      const size_t first = chosen[static_cast<size_t>(i)], second = chosen[static_cast<size_t>(j)];
      const Candidate &a = candidates[first], &b = candidates[second];
      if (a.same_place(b)) continue;
      Eigen::Matrix2d g;
      g << e.gram(i, i), e.gram(i, j), e.gram(i, j), e.gram(j, j);
      if (!(g.determinant() > kDistinct * g(0, 0) * g(1, 1))) continue;
      const Eigen::Vector2d right(e.right[i], e.right[j]), value = g.inverse() * right;
      if (!a.allows(value[0]) || !b.allows(value[1])) continue;
      pairs.push_back({first, second, value.dot(right) / residual_square});
    }
  std::sort(pairs.begin(), pairs.end(), [](const ScreenedPair& a, const ScreenedPair& b) { return a.gain > b.gain; });
  return pairs;
}

}  // namespace diagnosis::runs
