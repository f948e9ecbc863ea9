#include "drive_hold.hpp"

#include <algorithm>
#include <cmath>

#include "../record/consistency.hpp"
#include "sensor_check.hpp"

namespace diagnosis {
namespace {

constexpr double kThreshold = 15;  // fall of chi-squared that tells a hold from a smooth force, which shows 3 at most
constexpr double kMargin = 5;      // over what a fault of a sensor would explain

// Transfer from the samples of a force to the force itself, s = j omega T.
Complex transfer(Hold hold, Complex s) {
  if (hold == Hold::kSmooth || std::abs(s) < 1e-6) return 1;
  if (hold == Hold::kSteps) return (1.0 - std::exp(-s)) / s;
  return (std::exp(s) - 2.0 + std::exp(-s)) / (s * s);
}

// What folds back into the samples of a mass's motion per force and inverse mass: sampled response less that to the force
// below half the sampling rate. Of the displacement it is nothing, of the velocity under a linear hold likewise.
Complex folded(Hold hold, Complex s, size_t quantity, double period_s) {
  if (quantity == 2) return 1.0 - transfer(hold, s);
  if (quantity == 0 || hold != Hold::kSteps) return 0;
  if (std::abs(s) < 0.01) return -period_s * s / 12.0;
  return period_s * (1.0 / (std::exp(s) - 1.0) - transfer(hold, s) / s);
}

Complex step_of(const FusedRecord& f, Eigen::Index bin) { return {0, f.omega(bin) * f.period_s}; }

struct Evidence {
  double gain = 0, inverse_mass = 0;
};

Evidence evidence(const FusedRecord& f, size_t dof, const Spectrum& force, Hold hold) {
  const Consistency rows(f, dof);
  const Series residual = rows.residual();
  const Series column =
      rows.rows([&](Eigen::Index i, size_t q) { return folded(hold, step_of(f, i), q, f.period_s) * force[i]; });
  const double square = column.squaredNorm(), moment = column.dot(residual);
  if (!(square > 0)) return {};
  const double gain = moment * moment / square;
  return {gain / std::max(1.0, (residual.squaredNorm() - gain) / rows.dof()), moment / square};
}

void correct(FusedRecord& f, size_t dof, const Spectrum& force, double inverse_mass) {
  DofSpectra& s = f.spectra[dof];
  for (size_t q = 0; q < 3; ++q)
    for (Eigen::Index i = 0; s.measured[q] && i < s.z[q].size(); ++i)
      s.z[q][i] -= inverse_mass * folded(f.hold, step_of(f, i), q, f.period_s) * force[i];
}

Spectrum windowed_force(const FusedRecord& f, size_t dof) {
  return f.fourier->forward(f.outer.weight.cwiseProduct(f.force[dof]));
}

// What acts on average between the samples: right where the outer weight is 1; above the rows its noise stays as it is.
void let_act(FusedRecord& f, size_t dof, Spectrum force) {
  for (Eigen::Index i = 0; i <= 2 * f.last_bin; ++i) force[i] *= transfer(f.hold, step_of(f, i));
  f.force[dof] = f.fourier->inverse(force);
}

}  // namespace

bool tells_hold(const FusedRecord& f, size_t dof) { return f.spectra[dof].count() > 1 && f.spectra[dof].measured[2]; }

void impose_hold(FusedRecord& f, const KnownHold& known) {
  if (f.force[known.dof].size() == 0) return;
  const Spectrum force = windowed_force(f, known.dof);
  f.hold = known.hold;
  if (known.hold == Hold::kSteps) f.held.push_back(known.dof);
  correct(f, known.dof, force, known.inverse_mass);
  let_act(f, known.dof, force);
}

void correct_hold(FusedRecord& f) {
  for (size_t dof = 0; dof < f.force.size(); ++dof) {
    if (f.force[dof].size() == 0 || !tells_hold(f, dof)) continue;
    const Spectrum force = windowed_force(f, dof);
    Evidence best;
    Hold hold = Hold::kSmooth;
    for (Hold trial : {Hold::kLinear, Hold::kSteps}) {
      const Evidence e = evidence(f, dof, force, trial);
      if (e.inverse_mass > 0 && e.gain > best.gain) best = e, hold = trial;
    }
    if (best.gain < kThreshold || best.gain < strongest_fault(f, dof) + kMargin) continue;
    f.hold = hold;
    if (hold == Hold::kSteps) f.held.push_back(dof);
    // steps come half a sample late on average, and of that so much is not taken out right
    if (hold == Hold::kSteps) f.hold_doubt_s = std::max(f.hold_doubt_s, 0.5 * f.period_s / std::sqrt(best.gain));
    for (int round = 0; round < 3; ++round) {  // what was folded counted as noise before
      correct(f, dof, force, best.inverse_mass);
      estimate_noise(f);
      best = evidence(f, dof, force, hold);
    }
    let_act(f, dof, force);
    estimate_noise(f);
  }
}

}  // namespace diagnosis
