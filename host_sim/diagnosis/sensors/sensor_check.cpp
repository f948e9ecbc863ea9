#include "sensor_check.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "../record/consistency.hpp"

namespace diagnosis {
namespace {

constexpr double kThreshold = 25;  // fall of chi-squared that names a fault
constexpr double kSame = 12;       // of chi-squared: two that differ by less explain as well
constexpr int kMostFaults = 3;

// Spectra of the mains' waves that a record could show, cosine and sine, under the outer weight.
using Hums = std::map<FaultKind, std::array<Spectrum, 2>>;

Hums hums_of(const FusedRecord& f) {
  Hums list;
  for (FaultKind kind : {FaultKind::kHum50, FaultKind::kHum60}) {
    if (hum_Hz(kind) > f.omega(f.last_bin) / kTwoPi) continue;
    Series cosine = f.outer.weight, sine = f.outer.weight;
    for (Eigen::Index i = 0; i < cosine.size(); ++i) {
      const double phase = kTwoPi * hum_Hz(kind) * static_cast<double>(i) * f.period_s;
      cosine[i] *= std::cos(phase), sine[i] *= std::sin(phase);
    }
    list[kind] = {f.fourier->forward(cosine), f.fourier->forward(sine)};
  }
  return list;
}

std::vector<FaultKind> kinds_of(const Hums& hums) {
  std::vector<FaultKind> list{FaultKind::kDelay, FaultKind::kGain, FaultKind::kAcCoupling};
  for (const auto& hum : hums) list.push_back(hum.first);
  return list;
}

// Accelerometers have a high-pass of their own. Of what is slower in a displacement or a velocity, drift has more.
bool may_have(FaultKind kind, size_t quantity) { return kind != FaultKind::kAcCoupling || quantity == 2; }

std::vector<SensorFault> candidates(const FusedRecord& f, const Hums& hums, size_t dof) {
  const DofSpectra& s = f.spectra[dof];
  const Consistency rows(f, dof);
  const Series residual = rows.residual();
  std::vector<SensorFault> list;
  for (size_t q = 0; q < 3; ++q) {
    if (!s.measured[q]) continue;
    for (FaultKind kind : kinds_of(hums)) {
      if (!may_have(kind, q)) continue;
      Eigen::MatrixXd columns(residual.size(), is_hum(kind) ? 2 : 1);
      if (kind == FaultKind::kGain) {
        columns.col(0) = rows.disturbance(q, [&](Eigen::Index i) { return rows.seen(i, q); });
      } else if (kind == FaultKind::kDelay) {
        columns.col(0) = rows.disturbance(q, [&](Eigen::Index i) { return Complex(0, -f.omega(i)) * rows.seen(i, q); });
      } else if (kind == FaultKind::kAcCoupling) {  // jw / (jw + wc) is 1 + j wc / w for small wc
        columns.col(0) =
            rows.disturbance(q, [&](Eigen::Index i) { return Complex(0, kTwoPi / f.omega(i)) * rows.seen(i, q); });
      } else {
        for (Eigen::Index phase = 0; phase < 2; ++phase) {
          const Spectrum& wave = hums.at(kind)[static_cast<size_t>(phase)];
          columns.col(phase) = rows.disturbance(q, [&](Eigen::Index i) { return wave[i]; });
        }
      }
      const Eigen::MatrixXd gram = columns.transpose() * columns;
      const Eigen::VectorXd moment = columns.transpose() * residual, value = gram.ldlt().solve(moment);
      const double gain = value.dot(moment);
      const double left = std::max(1.0, (residual.squaredNorm() - gain) / rows.dof());
      SensorFault fault{
          kind, dof, q, s.channel[q], value[0], is_hum(kind) ? value[1] : 0, std::sqrt(left / gram(0, 0)), gain / left};
      if (std::isfinite(fault.score)) list.push_back(fault);
    }
  }
  std::sort(list.begin(), list.end(), [](const SensorFault& a, const SensorFault& b) { return a.score > b.score; });
  return list;
}

// (jw + wc) / jw
Complex undone_coupling(double omega, double corner_Hz) { return {1, -kTwoPi * corner_Hz / omega}; }

void correct(FusedRecord& f, const Hums& hums, const SensorFault& fault) {
  Spectrum& z = f.spectra[fault.dof].z[fault.quantity];
  if (fault.kind == FaultKind::kGain) {
    z /= 1 + std::clamp(fault.value, -0.5, 1.0);
  } else if (fault.kind == FaultKind::kDelay) {
    for (Eigen::Index i = 0; i < z.size(); ++i) z[i] *= std::exp(Complex(0, f.omega(i) * fault.value));
  } else if (fault.kind == FaultKind::kAcCoupling) {
    for (Eigen::Index i = 1; i < z.size(); ++i) z[i] *= undone_coupling(f.omega(i), fault.value);
  } else {
    z -= fault.value * hums.at(fault.kind)[0] + fault.quadrature * hums.at(fault.kind)[1];
  }
}

// The smallest of each that would be named, channel by channel; `seen` are the candidates of the DOF as it stands.
std::vector<SensorFault> smallest_faults(const FusedRecord& f, const Hums& hums, size_t dof,
                                         std::vector<SensorFault> seen) {
  std::sort(seen.begin(), seen.end(), [](const SensorFault& a, const SensorFault& b) {
    return std::tie(a.quantity, a.kind) < std::tie(b.quantity, b.kind);
  });
  for (SensorFault& fault : seen) fault.value = seen_in_95_of_100(kThreshold) * fault.std;
  if (f.spectra[dof].count() > 1) return seen;
  for (size_t q = 0; q < 3; ++q)
    for (FaultKind kind : kinds_of(hums))
      if (f.spectra[dof].measured[q] && may_have(kind, q))
        seen.push_back({kind, dof, q, f.spectra[dof].channel[q], std::numeric_limits<double>::infinity(), 0, 0, 0});
  return seen;
}

}  // namespace

void correct_fault(FusedRecord& f, const SensorFault& fault) { correct(f, hums_of(f), fault); }

void accumulate(SensorFault& total, const SensorFault& step) {
  if (total.kind == FaultKind::kGain)
    total.value = (1 + total.value) * (1 + step.value) - 1;
  else
    total.value += step.value, total.quadrature += step.quadrature;
  total.std = step.std;
}

double strongest_fault(const FusedRecord& f, size_t dof) {
  const std::vector<SensorFault> list = candidates(f, hums_of(f), dof);
  return list.empty() ? 0 : list.front().score;
}

namespace {

using Faults = std::vector<SensorFault>;

auto known_among(Faults& found, const SensorFault& fault) {
  return std::find_if(found.begin(), found.end(), [&](const SensorFault& s) { return same_fault(s, fault); });
}

// A corner is not negative, but for a further step of one that was found. And of one tone a high-pass is a delay: what explains as
// much without a memory of its own comes first.
Faults possible_faults(const FusedRecord& f, const Hums& hums, size_t dof, Faults& found) {
  Faults list = candidates(f, hums, dof);
  const auto coupling = [&](const SensorFault& s) {
    return s.kind == FaultKind::kAcCoupling && known_among(found, s) == found.end();
  };
  list.erase(
      std::remove_if(list.begin(), list.end(), [&](const SensorFault& s) { return coupling(s) && s.value <= 0; }),
      list.end());
  if (list.empty() || !coupling(list[0])) return list;
  const auto other = std::find_if(list.begin(), list.end(), [&](const SensorFault& s) { return !coupling(s); });
  if (other != list.end() && other->score > list[0].score - kSame) std::rotate(list.begin(), other, other + 1);
  return list;
}

// A further step of a fault. Corners add up; two high-passes in a row would be of second order.
void correct_further(FusedRecord& f, const Hums& hums, const SensorFault& total, const SensorFault& step) {
  if (step.kind != FaultKind::kAcCoupling) return correct(f, hums, step);
  Spectrum& z = f.spectra[step.dof].z[step.quantity];
  for (Eigen::Index i = 1; i < z.size(); ++i)
    z[i] *= undone_coupling(f.omega(i), total.value) / undone_coupling(f.omega(i), total.value - step.value);
}

}  // namespace

SensorCheck check_sensors(FusedRecord& f) {
  SensorCheck check;
  const Hums hums = hums_of(f);
  for (size_t dof = 0; dof < f.spectra.size(); ++dof) {
    Faults found, list;
    if (f.spectra[dof].count() > 1) list = possible_faults(f, hums, dof, found);
    for (int round = 0; round < 8 && !list.empty() && list[0].score >= kThreshold; ++round) {
      const auto known = known_among(found, list[0]);
      if (known == found.end() && found.size() == kMostFaults) break;
      if (known != found.end()) {
        accumulate(*known, list[0]);
        correct_further(f, hums, *known, list[0]);
      } else {
        found.push_back(list[0]);
        check.rivals.emplace_back();
        for (size_t i = 1; i < list.size(); ++i)
          if (list[i].score > list[0].score - kSame) check.rivals.back().push_back(list[i]);
        correct(f, hums, list[0]);
      }
      estimate_noise(f);
      list = possible_faults(f, hums, dof, found);
    }
    check.faults.insert(check.faults.end(), found.begin(), found.end());
    const std::vector<SensorFault> smallest = smallest_faults(f, hums, dof, list);
    check.smallest.insert(check.smallest.end(), smallest.begin(), smallest.end());
  }
  return check;
}

}  // namespace diagnosis
