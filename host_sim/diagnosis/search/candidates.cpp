// The columns of the candidates, shapes on a grid.
#include "candidates.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

std::vector<double> log_grid(double low, double high, int count) {
  std::vector<double> grid;
  for (int i = 0; i < count; ++i) grid.push_back(low * std::pow(high / low, i / static_cast<double>(count - 1)));
  return grid;
}

}  // namespace

CandidateBank::CandidateBank(const Rows& rows) : rows_(rows) {
  // Where nothing moves no resonance shows; one far above the motion is a mass.
  for (const FusedRecord& f : rows.records())
    highest_Hz_ = std::max(highest_Hz_, 1.4 * f.omega(motion_bin(f, 0.99)) / 6.283185307179586);
  highest_Hz_ =
      std::clamp(highest_Hz_, 0.006 / rows.records().front().period_s, 0.11 / rows.records().front().period_s);
  for (size_t l = 0; l < rows.system().links.size(); ++l) {
    const int link = static_cast<int>(l);
    for (Kind kind : {Kind::kMissingViscous, Kind::kMissingCoulomb}) add(on_link(kind, link), columns_);
    if (l < rows.system().known_links) add_effects(link, columns_);
  }
  for (size_t d = 0; d < rows.system().dofs(); ++d) add_dof(static_cast<int>(d));
  threshold_ = chance_threshold();
}

void CandidateBank::add(const Term& term, Columns& columns) const {
  columns.push_back(rows_.column(term));
  for (const Term& other : companions_of(term)) partner_[columns.back().get()].push_back(rows_.column(other));
}

CandidateBank::Extent CandidateBank::extent(int link) const {
  Extent e;
  for (size_t r = 0; r < rows_.records().size(); ++r) {
    const LinkMotion& m = rows_.link(r, static_cast<size_t>(link));
    e.u_peak = std::max(e.u_peak, m.u_peak), e.u_rms = std::max(e.u_rms, m.u_rms), e.w_rms = std::max(e.w_rms, m.w_rms);
  }
  return e;
}

CandidateBank::Range CandidateBank::range(const Term& t) const {
  if (t.kind == Kind::kResonance) {
    return {0.002 / rows_.records().front().period_s, 1.1 * highest_Hz_};
  }
  if (t.kind == Kind::kForceDelay) return {0.1 * t.shape, 10 * t.shape};
  const Extent e = extent(t.link);
  switch (t.kind) {
    case Kind::kBacklash:
      return {5e-5 * e.u_peak, 0.8 * e.u_peak};
    case Kind::kDriftingViscous:
      return {0.02 * duration_s(), 2 * duration_s()};
    case Kind::kEndStop:
      return {0.1 * e.u_peak, 0.97 * e.u_peak};
    case Kind::kStribeck:
      return {0.03 * e.w_rms, 1.1 * e.w_rms};
    default:
      return {5e-4 * e.u_rms, 1.5 * e.u_rms};
  }
}

CandidateBank::Range CandidateBank::second_range(const Term& t) const {
  if (t.kind == Kind::kResonance) return {1e-4, 0.5};
  return {0.02 * slide_s(t), 50 * slide_s(t)};
}

void CandidateBank::add_effects(int link, Columns& columns) const {
  for (Kind kind : {Kind::kCubicStiffness, Kind::kQuadraticStiffness, Kind::kStiffnessError, Kind::kQuadraticDamping,
                    Kind::kCubicDamping, Kind::kForceOffset, Kind::kAsymmetricViscous, Kind::kDisplacementDamping,
                    Kind::kDriftingViscous})
    add(on_link(kind, link), columns);
  for (double share : {0.05, 0.12, 0.3, 0.7}) add(on_link(Kind::kDriftingViscous, link, share * duration_s()), columns);
  const rig_file::Link& given = rows_.system().links[static_cast<size_t>(link)];
  const Extent e = extent(link);
  if (e.u_peak <= 0 || e.w_rms <= 0) return;
  if (given.stiffness_N_m.estimate || given.stiffness_N_m.value != 0)
    for (double gap : log_grid(1e-4 * e.u_peak, 0.5 * e.u_peak, 14)) add(on_link(Kind::kBacklash, link, gap), columns);
  for (double share : {0.2, 0.32, 0.43, 0.54, 0.65, 0.75, 0.85, 0.93})
    add(on_link(Kind::kEndStop, link, share * e.u_peak), columns);
  for (double speed : log_grid(0.04 * e.w_rms, 1.0 * e.w_rms, 7)) add(on_link(Kind::kStribeck, link, speed), columns);
  for (double length : log_grid(1e-3 * e.u_rms, 1.0 * e.u_rms, 9))
    for (double slides : {0.0, 0.7, 5.0}) {
      Term term = on_link(Kind::kPresliding, link, length);
      term.shape2 = slides * length / e.w_rms;
      add(term, columns);
    }
}

const CandidateBank::Columns& CandidateBank::effects_of_unlisted(int link) const {
  Columns& columns = unlisted_[link];
  if (columns.empty()) add_effects(link, columns);
  return columns;
}

void CandidateBank::add_dof(int dof) {
  add(on_dof(Kind::kMassError, dof), columns_);
  const Column mass = *columns_.back();
  const FusedRecord& first = rows_.records().front();
  // Hidden resonances: on the grid by their frequency response, which is exact but for the ends of the record.
  for (double hertz : log_grid(0.003 / first.period_s, highest_Hz_, 70)) {
    Column c = mass;
    c.term = on_dof(Kind::kResonance, dof, hertz, 0.02);
    for (size_t r = 0; r < rows_.records().size(); ++r) {
      const FusedRecord& f = rows_.records()[r];
      const double o = 6.283185307179586 * hertz;
      for (Eigen::Index i = 0; i < c.spectra[r].size(); ++i) {
        const double omega = f.omega(i + f.first_bin);
        const Complex drive(o * o, 2 * c.term.shape2 * o * omega);
        c.spectra[r][i] *= drive / (drive - omega * omega);
      }
    }
    c.mass = 0;
    columns_.push_back(std::make_shared<const Column>(c));
  }
  if (!rows_.has_force(static_cast<size_t>(dof))) return;
  add(on_dof(Kind::kForceGain, dof), columns_);
  for (double samples : {0.0, 1.0, -1.0, 2.5, -2.5, 6.0, -6.0, 15.0, -15.0})
    add(on_dof(Kind::kForceDelay, dof, samples * first.period_s), columns_);
  const double top_Hz = first.omega(first.last_bin) / 6.283185307179586;
  if (rows_.records().size() > 1) return;  // the phase of a hum differs between records
  if (top_Hz > 50) add(on_dof(Kind::kForceHumCos50, dof), columns_);
  if (top_Hz > 60) add(on_dof(Kind::kForceHumCos60, dof), columns_);
}

std::vector<Term> CandidateBank::companions_of(const Term& t) const {
  std::vector<Term> list;
  const auto also = [&](Kind kind, int record) {
    Term other = t;
    other.kind = kind, other.record = record;
    list.push_back(other);
  };
  if (t.kind == Kind::kForceHumCos50) also(Kind::kForceHumSin50, -1);
  if (t.kind == Kind::kForceHumCos60) also(Kind::kForceHumSin60, -1);
  if (t.kind == Kind::kResonance)  // the hidden mass moves already when a record starts
    for (size_t r = 0; r < rows_.records().size(); ++r)
      also(Kind::kResonanceCos, static_cast<int>(r)), also(Kind::kResonanceSin, static_cast<int>(r));
  if (t.kind == Kind::kQuadraticStiffness && !rows_.absolute())
    also(Kind::kStiffnessError, -1);  // about a mean that is not known
  return list;
}

}  // namespace diagnosis
