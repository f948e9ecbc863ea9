#include "tests/accuracy/skew_bound.hpp"

#include <cmath>
#include <unsupported/Eigen/FFT>

namespace accuracy {
namespace {

double square_sum(const std::vector<double>& values) {
  double sum = 0.0;
  for (double value : values) sum += value * value;
  return sum;
}

double information(const host_sim::Record& record, int dof, double noise_percent) {
  const std::vector<double>& x = record.find(host_sim::Quantity::kDisplacement, dof)->values;
  const std::vector<double>& v = record.find(host_sim::Quantity::kVelocity, dof)->values;
  const auto n = static_cast<double>(v.size());
  const double share = noise_percent * noise_percent / 1e4;
  const double sigma_x_square = share * square_sum(x) / n, sigma_v_square = share * square_sum(v) / n;
  Eigen::FFT<double> transform;
  std::vector<std::complex<double>> spectrum;
  transform.fwd(spectrum, v);
  double sum = 0.0;
  for (size_t k = 1; k < v.size() / 2; ++k) {
    const double omega = 2.0 * M_PI * static_cast<double>(k) / (n * record.sample_period_s);
    sum += 2.0 * std::norm(spectrum[k]) / n / (sigma_x_square + sigma_v_square / (omega * omega));
  }
  return sum;
}

}  // namespace

double skew_bound_s(const std::vector<host_sim::Record>& clean, int dof, double noise_percent) {
  double sum = 0.0;
  for (const host_sim::Record& record : clean) sum += information(record, dof, noise_percent);
  return 1.0 / std::sqrt(sum);
}

}  // namespace accuracy
