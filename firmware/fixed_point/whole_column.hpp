// Columns of whole numbers with one exponent each, and the sums over them that a solve spends its time in: exact, or
// rounded once. Compiled for speed where the rest of a solve is compiled for size.
#pragma once
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

// Numbers of one column: value times 2^exponent.
struct WholeColumn {
  const int32_t* value;
  int32_t exponent;
};

// Sum of the products of two columns' first `count` numbers; they and the sum stay below 2^63.
Scaled dot(WholeColumn a, WholeColumn b, int count);

// The numbers, rounded to `bits` (1 to 30) of the largest; returns their exponent.
int32_t round_to_column(const Scaled* numbers, int count, int bits, int32_t* value);

// target = sum over `terms` columns of factor times the column's number, rounded; factors are fractions of 30 bits.
constexpr int kColumnFactorBits = 30;
void add_columns(const int32_t* const* column, const int32_t* factor, int terms, int count, int32_t* target);

}  // namespace firmware
