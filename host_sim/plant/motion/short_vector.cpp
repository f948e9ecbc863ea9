#include "host_sim/plant/motion/short_vector.hpp"

#include <cmath>

namespace host_sim {
namespace {

// z = sum of c[k] x[k]; z may be x[0].
int linear_combination(int count, realtype* c, N_Vector* x, N_Vector z) {
  const sunindextype n = NV_LENGTH_S(z);
  realtype* const out = NV_DATA_S(z);
  for (sunindextype i = 0; i < n; ++i) {
    realtype sum = c[0] * NV_DATA_S(x[0])[i];
    for (int k = 1; k < count; ++k) sum += c[k] * NV_DATA_S(x[k])[i];
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
