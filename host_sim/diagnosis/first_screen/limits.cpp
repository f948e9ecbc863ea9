#include "limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../sensors/sensor_check.hpp"
#include "../terms/naming.hpp"

namespace diagnosis {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// rms over the equations' span of the force that has these spectra.
double rms_of(const Spectra& spectra, const Rows& rows) {
  double square = 0, samples = 0;
  for (size_t r = 0; r < spectra.size(); ++r) {
    const FusedRecord& f = rows.records()[r];
    square += power(spectra[r], f.first_bin == 0) / f.inner_energy;
    samples += static_cast<double>(f.samples);
  }
  return std::sqrt(square / samples);
}

// What the model's dampers on a link take together: viscous force and friction push the same way.
Spectra damper_force(const Rows& rows, const std::vector<ActiveTerm>& model, int link) {
  Spectra sum;
  for (const FusedRecord& f : rows.records()) sum.push_back(Spectrum::Zero(f.last_bin + 1 - f.first_bin));
  for (const ActiveTerm& t : model)
    if (t.term.link == link && (t.term.kind == Kind::kViscous || t.term.kind == Kind::kCoulomb))
      for (size_t r = 0; r < sum.size(); ++r) sum[r] += t.value * t.column->spectra[r];
  return sum;
}

// rms of what the dampers of each of the rig file's links take.
std::vector<double> damping_rms(const Rows& rows, const std::vector<ActiveTerm>& model) {
  std::vector<double> list;
  for (size_t l = 0; l < rows.system().known_links; ++l)
    list.push_back(rms_of(damper_force(rows, model, static_cast<int>(l)), rows));
  return list;
}

// Without the term in whose place they act: coefficients of their own.
std::vector<Candidate> freed(std::vector<Candidate> candidates) {
  for (Candidate& c : candidates) c.host = -1, c.fixed = false;
  return candidates;
}

std::vector<DetectionLimit> limits_of(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                                      const Fit& fit) {
  std::vector<DetectionLimit> list;
  std::vector<Candidate> candidates = bank.beside(model);
  const std::vector<Candidate> rivals = bank.seen_as_rivals(model);
  candidates.insert(candidates.end(), rivals.begin(), rivals.end());
  const std::vector<double> damping = damping_rms(rows, model);
  const std::vector<Gain> gains = gains_of(rows, model, fit, candidates),
                          free_gains = gains_of(rows, model, fit, freed(candidates));
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const Gain& gain = gains[i];
    if (c.term().kind == Kind::kForceDelay && c.term().shape != 0) continue;  // the smallest shows at first order
    if (gain.std <= 0 && c.host < 0) continue;
    const double steps = seen_in_95_of_100(c.threshold + c.penalty);
    const bool rotating = rotates(rows.system(), c.term());
    DetectionLimit limit{word_of(c.term().kind), place_of(rows.system(), c.term(), rows.records()[0]), 0, "", 0};
    const double noise = steps * std::sqrt(std::max(1.0, fit.ratio()));
    double coefficient = std::hypot(noise * gain.std, std::sqrt(c.threshold) * c.doubt);
    if (c.term().kind == Kind::kBacklash || c.term().kind == Kind::kPresliding) {
      // its coefficient is the host's: what is sought is the shape at which that is enough; nearly linear where small
      const double host = std::abs(model[static_cast<size_t>(c.host)].value);
      const double exponent = c.term().kind == Kind::kBacklash ? 1.0 : 2.0;
      if (host <= 0) continue;
      coefficient = noise * free_gains[i].std;
      limit.strength = c.term().shape * std::pow(coefficient / host, exponent);
      limit.unit = shape_unit(c.term().kind, rotating);
    } else {
      limit.strength = coefficient;
      limit.unit = unit_of(c.term().kind, rotating);
    }
    const double beside = damping_at(rows.system(), damping, c.term());
    limit.percent_of_damping_force = beside > 0 ? 100 * coefficient * rms_of(c.column->spectra, rows) / beside : 0;
    // of the shapes on the grid, and of the two mains frequencies, the easiest to see is quoted
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const DetectionLimit& l) { return l.same_place(limit); });
    if (known == list.end())
      list.push_back(limit);
    else if (limit.percent_of_damping_force < known->percent_of_damping_force)
      *known = limit;
  }
  for (const Term& t : bank.unseen(model))
    list.push_back({word_of(t.kind), place_of(rows.system(), t, rows.records()[0]), kNever,
                    unit_of(t.kind, rotates(rows.system(), t)), kNever});
  return list;
}

}  // namespace

double damping_at(const System& system, const std::vector<double>& damping, const Term& place) {
  if (place.link >= 0 && static_cast<size_t>(place.link) < damping.size())
    return damping[static_cast<size_t>(place.link)];
  const rig_file::Link* own = place.link >= 0 ? &system.links[static_cast<size_t>(place.link)] : nullptr;
  double largest = 0;
  for (size_t l = 0; l < damping.size(); ++l) {
    const rig_file::Link& link = system.links[l];
    const auto touches = [&](int dof) { return dof > 0 && (link.a == dof || link.b == dof); };
    if (own ? touches(own->a) || touches(own->b) : touches(place.dof + 1)) largest = std::max(largest, damping[l]);
  }
  return largest;
}

std::vector<DetectionLimit> detection_limits(Rows& rows, const CandidateBank& bank,
                                             const std::vector<ActiveTerm>& model, const Fit& fit) {
  std::vector<DetectionLimit> list = limits_of(rows, bank, model, fit);
  std::vector<ActiveTerm> copy = model;
  const Rows::Look look(rows, Rows::Reversals::kWide);
  const Fit wide = settle(rows, copy, 2);
  for (const DetectionLimit& other : limits_of(rows, bank, copy, wide)) {
    const bool shape_of_friction =
        other.effect == word_of(Kind::kStribeck) || other.effect == word_of(Kind::kPresliding);
    for (DetectionLimit& own : list)  // either look suffices to name it
      if (own.same_place(other) && other.strength < own.strength && !shape_of_friction) own = other;
  }
  return list;
}

}  // namespace diagnosis
