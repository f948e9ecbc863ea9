#include "outer_sums.hpp"

#include <algorithm>

#include "firmware/fixed_point/wider_vectors.hpp"

namespace diagnosis::runs {
namespace {

// GCC 12 vectorises these loops over two rows at a time and reads beyond the last one; the tiles are vectors without that.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC optimize("no-tree-loop-vectorize")
#endif

constexpr long kCached = 3072;  // numbers of a stretch of rows, that the nearest cache holds

// A part of the sum that registers hold.
template <int kWide, int kTall>
inline void add_tile(const Rows& a, const Rows& b, long count, long i, long j, double* sum) {
  double part[kTall][kWide] = {};
  const double *x = a.first + i, *y = b.first + j;
  for (long row = 0; row < count; ++row, x += a.stride, y += b.stride)
    for (int p = 0; p < kTall; ++p)
      for (int q = 0; q < kWide; ++q) part[p][q] += y[p] * x[q];
  for (int p = 0; p < kTall; ++p)
    for (int q = 0; q < kWide; ++q) sum[(j + p) * a.size + i + q] += part[p][q];
}

// All of the sum's rows for kTall of its columns.
template <int kTall>
inline void add_columns(const Rows& a, const Rows& b, long count, long j, bool lower, double* sum) {
  constexpr int kWide = 8;
  long i = lower ? j / kWide * kWide : 0;
  for (; i + kWide <= a.size; i += kWide) add_tile<kWide, kTall>(a, b, count, i, j, sum);
  if (i + kWide / 2 <= a.size) add_tile<kWide / 2, kTall>(a, b, count, i, j, sum), i += kWide / 2;
  for (; i < a.size; ++i) add_tile<1, kTall>(a, b, count, i, j, sum);
}

}  // namespace

FIRMWARE_WIDER_VECTORS void add_outer_sums(const Rows& a, const Rows& b, long count, double* sum, bool lower) {
  constexpr int kTall = 4;
  const long stretch = std::max<long>(1, kCached / std::max<long>(1, a.size + (lower ? 0 : b.size)));
  for (long from = 0; from < count; from += stretch) {
    const long rows = std::min(stretch, count - from);
    const Rows x{a.first + from * a.stride, a.size, a.stride}, y{b.first + from * b.stride, b.size, b.stride};
    long j = 0;
    for (; j + kTall <= b.size; j += kTall) add_columns<kTall>(x, y, rows, j, lower, sum);
    if (j + kTall / 2 <= b.size) add_columns<kTall / 2>(x, y, rows, j, lower, sum), j += kTall / 2;
    if (j < b.size) add_columns<1>(x, y, rows, j, lower, sum);
  }
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif

FIRMWARE_WIDER_VECTORS void add_row_sums(const Rows& a, const double* value, long count, double* __restrict square,
                                         double* __restrict with_next, double* __restrict with_value) {
  for (long row = 0; row < count; ++row) {
    const double* const x = a.first + row * a.stride;
    for (long i = 0; i < a.size; ++i) square[i] += x[i] * x[i], with_value[i] += x[i] * value[row];
    for (long i = 0; i + 1 < a.size; ++i) with_next[i] += x[i] * x[i + 1];
  }
}

}  // namespace diagnosis::runs
