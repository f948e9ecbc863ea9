// One pass over the windows for as many columns as memory holds; the first of them tells of the model beside.
#include "block_sums.hpp"

#include <algorithm>

#include "pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kAtOnce = 192;  // columns: bounds memory

BlockSums nothing(Index columns, size_t blocks) {
  BlockSums sums;
  sums.square = sums.with_next = sums.with_residual = Mat::Zero(columns, static_cast<Index>(blocks));
  sums.with_parameters.resize(blocks), sums.gram.resize(blocks), sums.score.resize(blocks);
  return sums;
}

// The columns from `from` on.
class Batch {
 public:
  Batch(BlockSums& sums, Index from) : sums_(sums), from_(from) {}

  // A window that is a block.
  void whole(size_t window, const ColumnSums& columns, const Sensitivity& slopes, const Vec& residual) {
    add_residual(residual);
    add_model(window, slopes, residual, 0, residual.size());
    take(window, columns);
  }

  // A window of that many blocks: each has a stretch of every channel.
  void divided(size_t window, Index length, Index parts, Mat& made, const Sensitivity& slopes, const Vec& residual) {
    add_residual(residual);
    for (Index part = 0; part < parts; ++part) {
      const size_t block = window * static_cast<size_t>(parts) + static_cast<size_t>(part);
      const Index first = part * length / parts, samples = (part + 1) * length / parts - first;
      ColumnSums columns(made.rows(), slopes.cols(), 0);
      for (Index at = first; at < residual.size(); at += length) {
        columns.add(made, 1, {}, slopes, residual, at, samples);
        add_model(block, slopes, residual, at, samples);
      }
      take(block, columns);
    }
  }

 private:
  bool first() const { return from_ == 0; }

  void add_residual(const Vec& residual) {
    if (first()) sums_.residual_square += residual.squaredNorm();
  }

  void add_model(size_t block, const Sensitivity& slopes, const Vec& residual, Index at, Index samples) {
    if (!first()) return;
    const Index p = slopes.cols();
    const auto own = slopes.middleRows(at, samples);
    Mat& gram = sums_.gram[block];
    Vec& score = sums_.score[block];
    if (gram.size() == 0 && score.size() == 0) gram = Mat::Zero(p, p), score = Vec::Zero(p);
    gram += own.transpose() * own, score += own.transpose() * residual.segment(at, samples);
  }

  void take(size_t block, const ColumnSums& columns) {
    const Index at = static_cast<Index>(block), count = columns.square.size();
    Mat& with_parameters = sums_.with_parameters[block];
    if (first()) with_parameters = Mat::Zero(sums_.columns(), columns.with_parameters.cols());
    sums_.with_residual.col(at).segment(from_, count) = columns.with_residual;
    sums_.square.col(at).segment(from_, count) = columns.square;
    sums_.with_next.col(at).segment(from_, count) = columns.with_next;
    with_parameters.middleRows(from_, count) = columns.with_parameters;
  }

  BlockSums& sums_;
  const Index from_;
};

}  // namespace

std::optional<BlockSums> sums_by_block(const System& system, const std::vector<Prepared>& records, const Model& model,
                                       const std::vector<Window>& windows, const Fitted& fit,
                                       const std::vector<Term>& terms) {
  const Index count = static_cast<Index>(terms.size()), parts = static_cast<Index>(parts_for(windows.size()));
  BlockSums sums = nothing(count, windows.size() * static_cast<size_t>(parts));
  for (Index from = 0; from < count; from += kAtOnce) {
    const std::vector<Term> some(terms.begin() + from, terms.begin() + std::min(count, from + kAtOnce));
    Pass pass(system, records, model, windows, fit);
    Batch batch(sums, from);
    const auto whole = [&](size_t w, const ColumnSums& columns, const Sensitivity& slopes, const Vec& residual) {
      batch.whole(w, columns, slopes, residual);
    };
    const auto divided = [&](size_t w, Mat& made, const Sensitivity& slopes, const Vec& residual) {
      batch.divided(w, windows[w].length, parts, made, slopes, residual);
    };
    if (!(parts == 1 ? pass.sums_over(some, whole) : pass.over(some, divided))) return std::nullopt;
  }
  return sums;
}

}  // namespace diagnosis::runs
