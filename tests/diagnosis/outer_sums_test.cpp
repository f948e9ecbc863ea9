// Sums of products over rows, against those made one by one.
#include "host_sim/diagnosis/fit/outer_sums.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <Eigen/Dense>

#include "host_sim/diagnosis/candidates/column_sums.hpp"

namespace {

using namespace diagnosis::runs;

Sensitivity waves(Index rows, Index columns, double pace) {
  Sensitivity m(rows, columns);
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < columns; ++c)
      m(r, c) = std::sin(pace * static_cast<double>(r + 1) * static_cast<double>(c + 1) + static_cast<double>(c));
  return m;
}

// Widths on both sides of every tile's, rows beyond a stretch, and rows of which a part is taken.
TEST(OuterSums, AreThoseOfTheirProducts) {
  for (const Index wide : {1, 3, 4, 7, 8, 13, 20, 65})
    for (const Index tall : {1, 2, 3, 6, 9}) {
      const Sensitivity a = waves(700, wide + 2, 0.37), b = waves(700, tall + 1, 0.11);
      Mat sum = Mat::Constant(wide, tall, 2);
      add_outer_sums({a.data() + 2, wide, wide + 2}, {b.data(), tall, tall + 1}, 700, sum.data());
      const Mat expected = (a.rightCols(wide).transpose() * b.leftCols(tall)).array() + 2;
      EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-10) << wide << " " << tall;
    }
}

TEST(OuterSums, OfARowWithItselfNeedTheirLowerHalfAlone) {
  for (const Index size : {1, 2, 5, 8, 11, 16, 30}) {
    const Sensitivity a = waves(500, size, 0.53);
    const Rows rows{a.data(), size, size};
    Mat sum = Mat::Zero(size, size);
    add_outer_sums(rows, rows, 500, sum.data(), true);
    const Mat difference = sum - Mat(a.transpose() * a);
    EXPECT_LT(Mat(difference.triangularView<Eigen::Lower>()).cwiseAbs().maxCoeff(), 1e-10) << size;
  }
}

// Numbers whose last one is the last that may be read: behind it lies a page that nobody may touch.
class AtTheEnd {
 public:
  explicit AtTheEnd(size_t numbers) : page_(static_cast<size_t>(sysconf(_SC_PAGESIZE))) {
    size_ = (numbers * sizeof(double) + page_ - 1) / page_ * page_;
    start_ =
        static_cast<char*>(mmap(nullptr, size_ + page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    mprotect(start_ + size_, page_, PROT_NONE);
    first = reinterpret_cast<double*>(start_ + size_) - numbers;
  }
  AtTheEnd(const AtTheEnd&) = delete;
  AtTheEnd& operator=(const AtTheEnd&) = delete;
  ~AtTheEnd() { munmap(start_, size_ + page_); }
  double* first;

 private:
  size_t page_, size_;
  char* start_;
};

TEST(OuterSums, ReadNothingBehindTheLastRow) {
  for (size_t wide = 1; wide < 20; ++wide)
    for (size_t tall = 1; tall < 20; ++tall)
      for (size_t count : {1, 2, 3, 8, 17}) {
        const AtTheEnd a(wide * count), b(tall * count);
        const auto w = static_cast<Index>(wide), t = static_cast<Index>(tall), rows = static_cast<Index>(count);
        Mat sum = Mat::Zero(w, t), own = Mat::Zero(w, w);
        add_outer_sums({a.first, w, w}, {b.first, t, t}, rows, sum.data());
        add_outer_sums({a.first, w, w}, {a.first, w, w}, rows, own.data(), true);
        Vec square = Vec::Zero(w), next = Vec::Zero(w), with = Vec::Zero(w), value = Vec::Zero(rows);
        add_row_sums({a.first, w, w}, value.data(), rows, square.data(), next.data(), with.data());
        EXPECT_EQ(sum.norm() + own.norm() + square.norm(), 0);
      }
}

// Columns that are not projected give the sums of projected ones, where what they are multiplied with is.
TEST(ColumnSums, AreThoseOfProjectedColumns) {
  constexpr Index kRows = 300, kColumns = 37, kStates = 5, kParameters = 3;
  Mat made = waves(kRows, kColumns, 0.37).transpose();
  const Eigen::HouseholderQR<Mat> qr(Mat(waves(kRows, kStates, 0.11)));
  const Mat basis = (qr.householderQ() * Mat::Identity(kRows, kStates)).transpose();
  const auto projected = [&](const Mat& m) { return Mat(m - basis.transpose() * (basis * m)); };
  const Sensitivity parameters = projected(waves(kRows, kParameters, 0.71));
  const Vec residual = projected(waves(kRows, 1, 0.93));
  const Mat weighted = projected(2.5 * made.transpose()).transpose();  // what it stands for
  ColumnSums sums(kColumns, kParameters, kStates);
  sums.add(made, 2.5, basis, parameters, residual, 0, 100), sums.add(made, 2.5, basis, parameters, residual, 100, 200);
  sums.take_out_states();
  EXPECT_LT((sums.square - weighted.rowwise().squaredNorm()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((sums.with_residual - weighted * residual).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((sums.with_parameters - weighted * parameters).cwiseAbs().maxCoeff(), 1e-9);
  for (Index i = 0; i + 1 < kColumns; ++i)
    EXPECT_NEAR(sums.with_next[i], weighted.row(i).dot(weighted.row(i + 1)), 1e-9) << i;
}

}  // namespace
