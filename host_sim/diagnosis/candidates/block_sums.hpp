// What a screening asks of the windows, block by block: sums of products of candidates' columns, the model's slopes and the residual.
#pragma once
#include <optional>

#include "candidates.hpp"

namespace diagnosis::runs {

// All free of what the windows' own states can make. A block is a window, or a consecutive stretch of one.
struct BlockSums {
  double residual_square = 0;            // over all blocks
  Mat square, with_next, with_residual;  // columns x blocks; with_next: with the next column
  std::vector<Mat> with_parameters;      // per block: columns x parameters
  std::vector<Mat> gram;                 // per block: parameters x parameters
  std::vector<Vec> score;                // per block: of parameters with the residual
  Index columns() const { return square.rows(); }
  size_t blocks() const { return gram.size(); }
  Index parameters() const { return gram.empty() ? 0 : gram[0].rows(); }
};

// `fit` has settled over `windows`. None where a window's run does not stay finite.
std::optional<BlockSums> sums_by_block(const System& system, const std::vector<Prepared>& records, const Model& model,
                                       const std::vector<Window>& windows, const Fitted& fit,
                                       const std::vector<Term>& terms);

}  // namespace diagnosis::runs
