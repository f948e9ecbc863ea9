// One pass over the windows with columns of candidates beside each, free of what the window's own state can make.
#pragma once
#include <Eigen/Dense>

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
  // visit(window index, projected columns, projected slopes of the parameters, projected residual)
  template <typename Visit>
  bool over(const std::vector<Term>& terms, Visit visit) {
    WindowRun run;
    Mat made;
    for (size_t i = 0; i < windows_.size(); ++i) {
      const Window& w = windows_[i];
      if (!evaluator_.run(w, true, true, run)) return false;
      const auto& traces = evaluator_.traces(w.record);
      columns_.make(terms, w, run, traces, made);
      const Index channels = static_cast<Index>(traces.size());
      for (Index c = 0; c < channels; ++c) {
        made.middleCols(c * w.length, w.length) *= weights_[c];
        run.slopes.middleRows(c * w.length, w.length) *= weights_[c];
        run.residual.segment(c * w.length, w.length) *= weights_[c];
      }
      const Index s = run.nuisances, p = run.slopes.cols() - s;
      Mat parameters = run.slopes.rightCols(p);
      if (s > 0) {
        const Mat states = run.slopes.leftCols(s);
        Mat a = states.transpose() * states;
        const Vec scale = a.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        a = scale.asDiagonal() * a * scale.asDiagonal();
        a.diagonal().array() += 1e-9;
        const Eigen::LLT<Mat> solver(a);
        const Mat basis =
            solver.matrixL().solve((scale.asDiagonal() * states.transpose()).eval());  // s x rows, orthonormal
        made -= (made * basis.transpose()) * basis;
        parameters -= basis.transpose() * (basis * parameters);
        run.residual -= basis.transpose() * (basis * run.residual);
      }
      visit(i, made, parameters, run.residual);
    }
    return true;
  }

 private:
  Evaluator evaluator_;
  const std::vector<Window>& windows_;
  Columns columns_;
  Vec weights_;
};

}  // namespace diagnosis::runs
