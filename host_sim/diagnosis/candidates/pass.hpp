// One pass over the windows with columns of candidates beside each, free of what the window's own state can make.
#pragma once
#include <Eigen/Dense>

#include "../fit/in_parallel.hpp"
#include "columns.hpp"

namespace diagnosis::runs {

class Pass {
 public:
  Pass(const System& system, const std::vector<Prepared>& records, const Model& model,
       const std::vector<Window>& windows, const Fitted& fit)
      : evaluator_(system, model, records), windows_(windows), columns_(system, model, records, evaluator_.massless()) {
    weights_ = fit.mean_square.cwiseSqrt().cwiseInverse();
  }
  Evaluator& evaluator() { return evaluator_; }
  // visit(window index, projected columns, projected slopes of the parameters, projected residual), in the order of the windows.
  // As many windows as there are lanes are run side by side; their columns are made in order, as one remembers what ended another.
  template <typename Visit>
  bool over(const std::vector<Term>& terms, Visit visit) {
    std::vector<Part> parts(lanes());
    for (size_t first = 0; first < windows_.size(); first += parts.size()) {
      const size_t count = std::min(parts.size(), windows_.size() - first);
      in_parallel(count, [&](size_t i, size_t lane) {
        parts[i].fine = evaluator_.run(windows_[first + i], true, true, parts[i].run, lane);
      });
      size_t fine = 0;
      for (; fine < count && parts[fine].fine; ++fine) {
        const Window& w = windows_[first + fine];
        columns_.make(terms, w, parts[fine].run, evaluator_.traces(w.record), parts[fine].made);
      }
      in_parallel(fine, [&](size_t i, size_t) { project(windows_[first + i], parts[i]); });
      for (size_t i = 0; i < fine; ++i) visit(first + i, parts[i].made, parts[i].parameters, parts[i].run.residual);
      if (fine < count) return false;
    }
    return true;
  }

 private:
  struct Part {
    bool fine = false;
    WindowRun run;
    Mat made, parameters;
  };
  // Weighted, and free of what the window's own state can make.
  void project(const Window& w, Part& part) const {
    Mat& made = part.made;
    WindowRun& run = part.run;
    for (Index c = 0; c < static_cast<Index>(evaluator_.traces(w.record).size()); ++c) {
      made.middleCols(c * w.length, w.length) *= weights_[c];
      run.slopes.middleRows(c * w.length, w.length) *= weights_[c];
      run.residual.segment(c * w.length, w.length) *= weights_[c];
    }
    const Index s = run.nuisances, p = run.slopes.cols() - s;
    part.parameters = run.slopes.rightCols(p);
    if (s == 0) return;
    const Mat states = run.slopes.leftCols(s);
    Mat a = states.transpose() * states;
    const Vec scale = a.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    a = scale.asDiagonal() * a * scale.asDiagonal();
    a.diagonal().array() += 1e-9;
    const Eigen::LLT<Mat> solver(a);
    const Mat basis =
        solver.matrixL().solve((scale.asDiagonal() * states.transpose()).eval());  // s x rows, orthonormal
    made -= (made * basis.transpose()) * basis;
    part.parameters -= basis.transpose() * (basis * part.parameters);
    run.residual -= basis.transpose() * (basis * run.residual);
  }

  Evaluator evaluator_;
  const std::vector<Window>& windows_;
  Columns columns_;
  Vec weights_;
};

}  // namespace diagnosis::runs
