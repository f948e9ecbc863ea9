#include <algorithm>
#include <cmath>

#include "pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kAtOnce = 192;      // columns: bounds memory
constexpr double kDistinct = 1e-5;  // share of a column's square that the model cannot make itself

struct Judged {
  double gain = 0, z = 0;
  std::vector<double> value;
};

}  // namespace

Screen screen(const System& system, const std::vector<Prepared>& records, const Model& model,
              const std::vector<Window>& windows, const Fitted& fit, const std::vector<Candidate>& candidates,
              size_t pairs) {
  Screen out;
  std::vector<Term> terms;
  std::vector<size_t> first;
  for (const Candidate& c : candidates) {
    first.push_back(terms.size());
    terms.insert(terms.end(), c.terms.begin(), c.terms.end());
  }
  const Index count = static_cast<Index>(terms.size());
  const size_t parts = parts_for(windows.size());
  const size_t nw = windows.size() * parts;  // blocks
  std::vector<Mat> own_model(nw), cross(nw, Mat());
  std::vector<Vec> own_score(nw);
  Mat residual = Mat::Zero(count, static_cast<Index>(nw)), square = residual,
      mate = residual;  // mate: with the next column
  double total = 0;
  for (Index from = 0; from < count; from += kAtOnce) {
    const Index n = std::min(kAtOnce, count - from);
    const std::vector<Term> some(terms.begin() + from, terms.begin() + from + n);
    Pass pass(system, records, model, windows, fit);
    const auto take = [&](size_t block, const ColumnSums& sums) {
      const Index col = static_cast<Index>(block);
      if (from == 0) cross[block] = Mat::Zero(count, sums.with_parameters.cols());
      residual.col(col).segment(from, n) = sums.with_residual, square.col(col).segment(from, n) = sums.square;
      mate.col(col).segment(from, n) = sums.with_next, cross[block].middleRows(from, n) = sums.with_parameters;
    };
    const auto take_model = [&](size_t block, const Sensitivity& b, const Vec& r, Index at, Index samples) {
      if (from > 0) return;
      const auto own = b.middleRows(at, samples);
      if (own_model[block].size() == 0 && own_score[block].size() == 0)
        own_model[block] = Mat::Zero(b.cols(), b.cols()), own_score[block] = Vec::Zero(b.cols());
      own_model[block] += own.transpose() * own, own_score[block] += own.transpose() * r.segment(at, samples);
    };
    const bool fine = parts == 1
                          ? pass.sums_over(some,
                                           [&](size_t w, const ColumnSums& sums, const Sensitivity& b, const Vec& r) {
                                             if (from == 0) total += r.squaredNorm();
                                             take_model(w, b, r, 0, r.size()), take(w, sums);
                                           })
                          : pass.over(some, [&](size_t w, Mat& c, const Sensitivity& b, const Vec& r) {
                              if (from == 0) total += r.squaredNorm();
                              const Index len = windows[w].length, blocks = static_cast<Index>(parts);
                              for (Index part = 0; part < blocks; ++part) {
                                const size_t block = w * parts + static_cast<size_t>(part);
                                const Index first_sample = part * len / blocks,
                                            samples = (part + 1) * len / blocks - first_sample;
                                ColumnSums sums(n, b.cols(), 0);
                                for (Index at = first_sample; at < r.size(); at += len)
                                  sums.add(c, 1, {}, b, r, at, samples), take_model(block, b, r, at, samples);
                                take(block, sums);
                              }
                            });
    if (!fine) return out;
  }
  const Index p = own_model.empty() ? 0 : own_model[0].rows();
  Mat gram = Mat::Zero(p, p), all_cross = Mat::Zero(count, p);
  Vec score = Vec::Zero(p);
  for (size_t w = 0; w < nw; ++w) gram += own_model[w], all_cross += cross[w], score += own_score[w];
  Mat inverse = Mat::Zero(p, p);
  if (p > 0) {
    const Vec scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Mat a = scale.asDiagonal() * gram * scale.asDiagonal();
    a.diagonal().array() += 1e-10;
    inverse = scale.asDiagonal() * a.ldlt().solve(Mat::Identity(p, p)) * scale.asDiagonal();
  }
  const Mat beta = all_cross * inverse;  // columns x parameters
  const auto single = [&](Index i) {
    Judged j;
    const double whole = square.row(i).sum();
    const double left = whole - beta.row(i).dot(all_cross.row(i));
    if (!(left > kDistinct * whole)) return j;
    const double right = residual.row(i).sum() - beta.row(i).dot(score);
    const double value = right / left;
    double influence = 0, leverage = 0;
    for (size_t w = 0; w < nw; ++w) {
      const double own = square(i, static_cast<Index>(w)) - 2 * beta.row(i).dot(cross[w].row(i)) +
                         beta.row(i) * own_model[w] * beta.row(i).transpose();
      const double h = std::clamp(own / left, 0.0, 0.95);
      const double s =
          (residual(i, static_cast<Index>(w)) - beta.row(i).dot(own_score[w]) - value * own) / left / (1 - h);
      influence += s * s, leverage += h * h;
    }
    j.value = {value}, j.gain = right * value / total;
    j.z = std::abs(normal_deviate(value / std::sqrt(influence + 1e-300), std::max(1.0, 1 / std::max(1e-12, leverage))));
    return j;
  };
  const auto double_column = [&](Index i) {
    Judged j;
    Eigen::Matrix2d a;
    Eigen::Vector2d b;
    for (Index k = 0; k < 2; ++k) {
      a(k, k) = square.row(i + k).sum() - beta.row(i + k).dot(all_cross.row(i + k));
      b[k] = residual.row(i + k).sum() - beta.row(i + k).dot(score);
    }
    a(0, 1) = a(1, 0) = mate.row(i).sum() - beta.row(i).dot(all_cross.row(i + 1));
    if (!(a.determinant() > 1e-8 * a(0, 0) * a(1, 1))) return j;
    const Eigen::Vector2d v = a.inverse() * b;
    j.value = {v[0], v[1]}, j.gain = v.dot(b) / total;
    j.z = std::max(single(i).z, single(i + 1).z);
    return j;
  };
  std::vector<Screened> all;
  for (size_t c = 0; c < candidates.size(); ++c) {
    const Index i = static_cast<Index>(first[c]);
    const Judged j = candidates[c].terms.size() == 2 ? double_column(i) : single(i);
    if (j.value.empty() || !std::isfinite(j.gain)) continue;
    Vec moves = Vec::Zero(p);
    for (size_t k = 0; k < j.value.size(); ++k) moves -= j.value[k] * beta.row(i + static_cast<Index>(k)).transpose();
    all.push_back({c, j.gain, j.z, j.value, moves});
  }
  std::sort(all.begin(), all.end(), [](const Screened& a, const Screened& b) { return a.gain > b.gain; });
  for (const Screened& s : all) {
    if (candidates[s.candidate].sign != 0 && candidates[s.candidate].sign * s.value[0] < 0) continue;
    const bool seen = std::any_of(out.singles.begin(), out.singles.end(), [&](const Screened& o) {
      return candidates[o.candidate].same_place(candidates[s.candidate]);
    });
    if (!seen) out.singles.push_back(s);
  }
  // Two at a time, in closed form: of every kind and place its three best shapes.
  std::vector<size_t> chosen;
  for (const Screened& s : all) {
    if (chosen.size() >= pairs) break;
    if (candidates[s.candidate].terms.size() > 1) continue;
    const auto same = std::count_if(chosen.begin(), chosen.end(),
                                    [&](size_t o) { return candidates[o].same_place(candidates[s.candidate]); });
    if (same < 2) chosen.push_back(s.candidate);
  }
  if (chosen.size() < 2) return out;
  std::vector<Term> some;
  for (size_t c : chosen) some.push_back(candidates[c].terms[0]);
  const Index n = static_cast<Index>(some.size());
  Mat all_gram = Mat::Zero(n, n), with_model = Mat::Zero(n, p);
  Vec right = Vec::Zero(n);
  Pass pass(system, records, model, windows, fit);
  pass.over(some, [&](size_t, const Mat& c, const Sensitivity& b, const Vec& r) {
    all_gram.noalias() += c * c.transpose(), with_model.noalias() += c * b, right.noalias() += c * r;
  });
  all_gram -= with_model * inverse * with_model.transpose();
  right -= with_model * inverse * score;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < i; ++j) {
      const Candidate &a = candidates[chosen[static_cast<size_t>(i)]], &b = candidates[chosen[static_cast<size_t>(j)]];
      if (a.same_place(b)) continue;
      Eigen::Matrix2d g;
      g << all_gram(i, i), all_gram(i, j), all_gram(i, j), all_gram(j, j);
      if (!(g.determinant() > 1e-4 * g(0, 0) * g(1, 1))) continue;
      const Eigen::Vector2d rhs(right[i], right[j]), v = g.inverse() * rhs;
      if ((a.sign != 0 && a.sign * v[0] < 0) || (b.sign != 0 && b.sign * v[1] < 0)) continue;
      out.pairs.push_back({chosen[static_cast<size_t>(i)], chosen[static_cast<size_t>(j)], v.dot(rhs) / total});
    }
  std::sort(out.pairs.begin(), out.pairs.end(),
            [](const ScreenedPair& a, const ScreenedPair& b) { return a.gain > b.gain; });
  return out;
}

}  // namespace diagnosis::runs
