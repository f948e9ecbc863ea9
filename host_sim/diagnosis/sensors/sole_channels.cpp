#include "sole_channels.hpp"

#include <algorithm>
#include <cmath>

#include "../rows/dynamics.hpp"

namespace diagnosis {
namespace {

// Forces of a linear model on every DOF (samples x DOFs).
using Forces = Eigen::MatrixXd;

// that a motion of one DOF makes
Forces forces_of(const Dynamics& d, Eigen::Index dof, const DofMotion& m) {
  return m.smooth_a * d.mass.col(dof).transpose() + m.smooth_v * d.viscous.col(dof).transpose() +
         m.smooth_x * d.stiffness.col(dof).transpose();
}

// that a wave of unit amplitude in one channel makes: phase 0 its cosine, 1 its sine
Forces forces_of_wave(const Dynamics& d, Eigen::Index dof, int quantity, double hertz, int phase,
                      const FusedRecord& f) {
  const double omega = kTwoPi * hertz;
  const Spectrum response =
      (d.stiffness.col(dof) - omega * omega * d.mass.col(dof)).cast<Complex>() + Complex(0, omega) * d.viscous.col(dof);
  Forces forces(static_cast<Eigen::Index>(f.samples), response.size());
  for (Eigen::Index i = 0; i < forces.rows(); ++i) {
    const Complex wave = std::polar(1.0, omega * static_cast<double>(i) * f.period_s) / derivative(omega, quantity);
    for (Eigen::Index k = 0; k < response.size(); ++k)
      forces(i, k) = phase == 0 ? (response[k] * wave).real() : (response[k] * wave).imag();
  }
  return forces;
}

Balance balance_of(const FusedRecord& f, const Forces& forces, double factor, bool slope) {
  Balance b = Balance::Zero(f.last_bin + 1 - f.first_bin, forces.cols());
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    if (forces.col(k).isZero(0)) continue;  // no neighbour
    const Series force = forces.col(k);
    b.col(k) = factor * row_spectrum(f, slope ? lateness(force, 0, f) : force);
  }
  return b;
}

// What a fault of unit size leaves of the equations, per record: measured force less that of the faulty motion. A gain error g
// makes it -g F, a delay tau + tau dF/dt, F the forces of the true motion.
std::vector<std::vector<Balance>> imbalances(const Rows& rows, const Dynamics& d, const SensorFault& fault) {
  std::vector<std::vector<Balance>> group(is_hum(fault.kind) ? 2 : 1);
  const Eigen::Index dof = static_cast<Eigen::Index>(fault.dof);
  for (const FusedRecord& f : rows.records())
    for (size_t phase = 0; phase < group.size(); ++phase) {
      const Forces forces = is_hum(fault.kind) ? forces_of_wave(d, dof, static_cast<int>(fault.quantity),
                                                                hum_Hz(fault.kind), static_cast<int>(phase), f)
                                               : forces_of(d, dof, f.motion[fault.dof]);
      group[phase].push_back(balance_of(f, forces, -1, fault.kind == FaultKind::kDelay));
    }
  return group;
}

std::vector<FaultKind> kinds_of(const Rows& rows) {
  const FusedRecord& f = rows.records().front();
  std::vector<FaultKind> list{FaultKind::kDelay, FaultKind::kGain};
  if (rows.records().size() > 1) return list;  // the phase of a hum differs between records
  for (FaultKind kind : {FaultKind::kHum50, FaultKind::kHum60})
    if (hum_Hz(kind) < f.omega(f.last_bin) / kTwoPi) list.push_back(kind);
  return list;
}

}  // namespace

bool has_sole_channel(const FusedRecord& f) {
  return std::any_of(f.spectra.begin(), f.spectra.end() - 1, [](const DofSpectra& s) { return s.count() == 1; });
}

std::vector<SensorFault> sole_channel_faults(const Rows& rows, const std::vector<ActiveTerm>& model, const Fit& fit) {
  const Dynamics dynamics(rows.system(), model, Dynamics::Others::kAlike);
  std::vector<SensorFault> list;
  for (size_t dof = 0; dof < rows.system().dofs(); ++dof) {
    const DofSpectra& s = rows.records().front().spectra[dof];
    if (s.count() != 1) continue;
    const size_t quantity = s.first();
    for (FaultKind kind : kinds_of(rows)) {
      SensorFault fault{kind, dof, quantity, s.channel[quantity], 0, 0, 0, 0};
      const Projection::Explained e = fit.projection->explained(imbalances(rows, dynamics, fault));
      if (!(e.std[0] > 0) || !std::isfinite(e.chi2)) continue;
      const double left = std::max(1.0, (fit.chi2 - e.chi2) / fit.dof);
      fault.value = e.value[0], fault.quadrature = is_hum(kind) ? e.value[1] : 0;
      fault.std = e.std[0] * std::sqrt(left), fault.score = e.chi2 / left;
      list.push_back(fault);
    }
  }
  std::sort(list.begin(), list.end(), [](const SensorFault& a, const SensorFault& b) { return a.score > b.score; });
  return list;
}

}  // namespace diagnosis
