// One pass over the windows with columns of candidates beside each, free of what the window's own state can make.
#pragma once
#include <Eigen/Dense>

#include "../fit/in_parallel.hpp"
#include "../fit/outer_sums.hpp"
#include "column_sums.hpp"
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
  template <typename Visit>
  bool over(const std::vector<Term>& terms, Visit visit) {
    return each(
        terms, [&](const Window& w, Part& part) { project_columns(w, part, project(w, part)); },
        [&](size_t i, Part& part) { visit(i, part.made, part.parameters, part.run.residual); });
  }
  // visit(window index, sums of the columns, slopes and residual as above). The columns themselves need not be projected for it, which
  // is most of the work.
  template <typename Visit>
  bool sums_over(const std::vector<Term>& terms, Visit visit) {
    return each(
        terms,
        [&](const Window& w, Part& part) {
          const Mat basis = project(w, part);
          ColumnSums sums(part.made.rows(), part.parameters.cols(), basis.rows());
          for (Index c = 0; c < weights_.size(); ++c)
            sums.add(part.made, weights_[c], basis, part.parameters, part.run.residual, c * w.length, w.length);
          sums.take_out_states();
          part.sums = std::move(sums);
        },
        [&](size_t i, Part& part) { visit(i, part.sums, part.parameters, part.run.residual); });
  }

 private:
  struct Part {
    bool fine = false;
    WindowRun run;
    Mat made;
    Sensitivity parameters;
    ColumnSums sums{0, 0, 0};
  };
  // As many windows as there are lanes are run side by side; their columns are made in order, as one remembers what ended another.
  template <typename Work, typename Visit>
  bool each(const std::vector<Term>& terms, Work work, Visit visit) {
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
        evaluator_.leave_out_reversals(w, parts[fine].made);
      }
      in_parallel(fine, [&](size_t i, size_t) { work(windows_[first + i], parts[i]); });
      for (size_t i = 0; i < fine; ++i) visit(first + i, parts[i]);
      if (fine < count) return false;
    }
    return true;
  }
  // Slopes and residual, weighted and free of what the window's own state can make: of that a basis, a row each.
  Mat project(const Window& w, Part& part) const {
    WindowRun& run = part.run;
    for (Index c = 0; c < weights_.size(); ++c) {
      run.slopes.middleRows(c * w.length, w.length) *= weights_[c];
      run.residual.segment(c * w.length, w.length) *= weights_[c];
    }
    const Index s = run.nuisances, p = run.slopes.cols() - s;
    part.parameters = run.slopes.rightCols(p);
    Mat a = Mat::Zero(s, s);
    if (s == 0) return a;
    const Rows states{run.slopes.data(), s, s + p};
    add_outer_sums(states, states, run.slopes.rows(), a.data(), true);
    const Vec scale = a.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    a = scale.asDiagonal() * a * scale.asDiagonal();
    a.diagonal().array() += 1e-9;
    const Eigen::LLT<Mat> solver(a);
    const Mat basis = solver.matrixL().solve(
        (scale.asDiagonal() * run.slopes.leftCols(s).transpose()).eval());  // s x rows, orthonormal
    part.parameters -= basis.transpose() * (basis * part.parameters);
    run.residual -= basis.transpose() * (basis * run.residual);
    return basis;
  }
  void project_columns(const Window& w, Part& part, const Mat& basis) const {
    for (Index c = 0; c < weights_.size(); ++c) part.made.middleCols(c * w.length, w.length) *= weights_[c];
    if (basis.rows() > 0) part.made -= (part.made * basis.transpose()) * basis;
  }

  Evaluator evaluator_;
  const std::vector<Window>& windows_;
  Columns columns_;
  Vec weights_;
};

}  // namespace diagnosis::runs
