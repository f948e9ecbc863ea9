#include "host_sim/plant/motion/short_vector.hpp"

#include <cmath>

namespace host_sim {
namespace {

// z = sum of c[k] x[k]; z may be x[0].
int linear_combination(int count, realtype* c, N_Vector* x, N_Vector z) {
  const sunindextype n = NV_LENGTH_S(z);
  realtype* const out = NV_DATA_S(z);
  constexpr int kMost = 16;  // of the tables that are used here: 13 stages and the state
  const realtype* from[kMost];
  if (count > kMost) return -1;
  for (int k = 0; k < count; ++k) from[k] = NV_DATA_S(x[k]);
  sunindextype i = 0;
  for (; i + 1 < n; i += 2) {  // two at a time: each sum is long, and waits for itself
    realtype first = c[0] * from[0][i], second = c[0] * from[0][i + 1];
    for (int k = 1; k < count; ++k) first += c[k] * from[k][i], second += c[k] * from[k][i + 1];
    out[i] = first;
    out[i + 1] = second;
  }
  for (; i < n; ++i) {
    realtype sum = c[0] * from[0][i];
    for (int k = 1; k < count; ++k) sum += c[k] * from[k][i];
    out[i] = sum;
  }
  return 0;
}

void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
  const sunindextype n = NV_LENGTH_S(z);
  const realtype *const p = NV_DATA_S(x), *const q = NV_DATA_S(y);
  realtype* const out = NV_DATA_S(z);
  for (sunindextype i = 0; i < n; ++i) out[i] = a * p[i] + b * q[i];
}

void scale(realtype c, N_Vector x, N_Vector z) {
  const sunindextype n = NV_LENGTH_S(z);
  const realtype* const p = NV_DATA_S(x);
  realtype* const out = NV_DATA_S(z);
  for (sunindextype i = 0; i < n; ++i) out[i] = c * p[i];
}

realtype weighted_rms(N_Vector x, N_Vector weight) {
  const sunindextype n = NV_LENGTH_S(x);
  const realtype *const p = NV_DATA_S(x), *const w = NV_DATA_S(weight);
  realtype sum = 0.0;
  for (sunindextype i = 0; i < n; ++i) sum += (p[i] * w[i]) * (p[i] * w[i]);
  return std::sqrt(sum / static_cast<realtype>(n));
}

}  // namespace

void use_short_loops(N_Vector vector) {
  vector->ops->nvlinearcombination = linear_combination;
  vector->ops->nvlinearsum = linear_sum;
  vector->ops->nvscale = scale;
  vector->ops->nvwrmsnorm = weighted_rms;
}

}  // namespace host_sim
