#include "candidates.hpp"

#include <algorithm>
#include <cmath>

#include "hal/configuration/effect_words.hpp"

namespace diagnosis {
namespace {

Term on_link(Kind kind, int link, double shape = 0) { return {kind, link, -1, shape, 0}; }
Term on_dof(Kind kind, int dof, double shape = 0, double shape2 = 0) { return {kind, -1, dof, shape, shape2}; }

std::vector<double> log_grid(double low, double high, int count) {
  std::vector<double> grid;
  for (int i = 0; i < count; ++i) grid.push_back(low * std::pow(high / low, i / static_cast<double>(count - 1)));
  return grid;
}

bool is_stiffness(Kind kind) { return kind == Kind::kStiffness; }
bool is_friction(Kind kind) { return kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb; }

// The term of the model that a shape effect bends, or -1.
template <typename Test>
int host_on(const std::vector<ActiveTerm>& model, int link, Test test) {
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].term.link == link && test(model[i].term.kind) && model[i].host < 0 &&
        (!model[i].known || model[i].value != 0))
      return static_cast<int>(i);
  return -1;
}

}  // namespace

std::vector<ActiveTerm> base_model(const Rows& rows) {
  const System& s = rows.system();
  std::vector<ActiveTerm> model;
  const auto add = [&](const Term& term, const rig_file::Coefficient& c, bool always) {
    if (!always && !c.estimate && c.value == 0) return;
    ActiveTerm t;
    Term own = term;
    own.smooth = c.estimate;
    t.term = own;
    t.column = rows.column(own);
    t.known = !c.estimate;
    t.value = c.estimate ? 0 : c.value;
    model.push_back(t);
  };
  for (size_t i = 0; i < s.dofs(); ++i) {
    add(on_dof(Kind::kMass, static_cast<int>(i)), s.rig.dofs[i].mass_kg, false);
    for (const rig_file::Effect& e : s.rig.dofs[i].effects) {
      Term term = on_dof(Kind::kMass, static_cast<int>(i));
      if (!kind_of_word(e.kind, &term.kind)) continue;
      term.given = true;
      if (e.shape.count("resonance_Hz")) term.shape = e.shape.at("resonance_Hz");
      if (e.shape.count("damping_ratio")) term.shape2 = e.shape.at("damping_ratio");
      add(term, e.coefficient, true);
    }
  }
  for (size_t l = 0; l < s.known_links; ++l) {
    const rig_file::Link& link = s.links[l];
    const int i = static_cast<int>(l);
    add(on_link(Kind::kStiffness, i), link.stiffness_N_m, false);
    add(on_link(Kind::kViscous, i), link.viscous_N_s_m, false);
    add(on_link(Kind::kCoulomb, i), link.coulomb_N, false);
    add(on_link(Kind::kGravity, i), link.gravity_torque_N_m, false);
    for (const rig_file::Effect& e : link.effects) {
      Term term = on_link(Kind::kStiffness, i);
      if (!kind_of_word(e.kind, &term.kind)) continue;
      term.given = true;
      term.shape = rig_file::first_shape(e, rig_file::link_rotates(s.rig, link));
      add(term, e.coefficient, true);
    }
  }
  return model;
}

CandidateBank::CandidateBank(const Rows& rows) : rows_(rows) {
  // Where nothing moves no resonance shows; one far above the motion is a mass.
  for (const FusedRecord& f : rows.records())
    highest_Hz_ = std::max(highest_Hz_, 1.4 * f.omega(motion_bin(f, 0.99)) / 6.283185307179586);
  highest_Hz_ = std::clamp(highest_Hz_, 0.006 / rows.records().front().period_s, 0.11 / rows.records().front().period_s);
  for (size_t l = 0; l < rows.system().links.size(); ++l) {
    const int link = static_cast<int>(l);
    for (Kind kind : {Kind::kMissingViscous, Kind::kMissingCoulomb}) add(on_link(kind, link), columns_);
    if (l < rows.system().known_links) add_effects(link, columns_);
  }
  for (size_t d = 0; d < rows.system().dofs(); ++d) add_dof(static_cast<int>(d));
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
  const Extent e = extent(t.link);
  switch (t.kind) {
    case Kind::kBacklash: return {5e-5 * e.u_peak, 0.8 * e.u_peak};
    case Kind::kDriftingViscous: return {0.02 * duration_s(), 2 * duration_s()};
    case Kind::kEndStop: return {0.1 * e.u_peak, 0.97 * e.u_peak};
    case Kind::kStribeck: return {0.03 * e.w_rms, 1.1 * e.w_rms};
    default: return {5e-4 * e.u_rms, 1.5 * e.u_rms};
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
  for (Kind kind : {Kind::kForceDelay, Kind::kForceGain}) add(on_dof(kind, dof), columns_);
  const double top_Hz = first.omega(first.last_bin) / 6.283185307179586;
  if (rows_.records().size() > 1) return;  // the phase of a hum differs between records
  if (top_Hz > 50) add(on_dof(Kind::kForceHumCos50, dof), columns_);
  if (top_Hz > 60) add(on_dof(Kind::kForceHumCos60, dof), columns_);
}

bool CandidateBank::has_shape(const Term& t) {
  const Kind kind = t.kind;
  return (kind == Kind::kDriftingViscous && t.shape > 0) || kind == Kind::kBacklash || kind == Kind::kEndStop || kind == Kind::kStribeck || kind == Kind::kPresliding ||
         kind == Kind::kResonance;
}

bool CandidateBank::observable(const std::vector<ActiveTerm>& model, const Term& t) const {
  // Without a known coefficient the force sets the scale of all others; without a force a single mass does.
  bool scale_known = false, forced = false;
  for (const ActiveTerm& a : model) scale_known = scale_known || (!a.added && a.known && a.value != 0);
  for (size_t j = 0; j < rows_.system().dofs(); ++j) forced = forced || rows_.has_force(j);
  if (t.kind == Kind::kForceGain) return scale_known;
  if (t.kind == Kind::kMassError) return forced || rows_.system().dofs() > 1;
  return t.kind != Kind::kForceOffset || rows_.absolute();  // a static force shows in a static displacement
}

std::vector<Term> CandidateBank::unseen(const std::vector<ActiveTerm>& model) const {
  std::vector<Term> list;
  for (const auto& column : columns_)
    if (!observable(model, column->term)) list.push_back(column->term);
  return list;
}

bool CandidateBank::prepare(const std::vector<ActiveTerm>& model, Candidate& c) const {
  const Term& t = c.term();
  if (!observable(model, t)) return false;
  for (const Term& b : barred_)
    if (b.same_place(t)) return false;
  for (const ActiveTerm& a : model) {
    const Term& other = a.term;
    if (other.same_place(t)) return false;
    if (other.link == t.link && t.link >= 0) {
      if (t.kind == Kind::kMissingViscous && other.kind == Kind::kViscous && !a.known) return false;
      if (t.kind == Kind::kMissingCoulomb && other.kind == Kind::kCoulomb) return false;
      if (t.kind == Kind::kStiffnessError && other.kind == Kind::kStiffness && !a.known) return false;
    }
    if (t.kind == Kind::kMassError && other.kind == Kind::kMass && other.dof == t.dof && !a.known) return false;
  }
  switch (t.kind) {
    case Kind::kBacklash:
      c.host = host_on(model, t.link, is_stiffness), c.host_sign = -1;
      c.penalty = 6;
      break;
    case Kind::kPresliding:
      c.host = host_on(model, t.link, is_friction), c.host_sign = 1;
      c.penalty = t.shape2 > 0 ? 12 : 6, c.threshold = 100;
      break;
    case Kind::kStribeck: c.coefficient_sign = 1, c.penalty = 6, c.threshold = 100; return true;
    case Kind::kEndStop: c.coefficient_sign = 1, c.penalty = 6; return true;
    case Kind::kDriftingViscous: c.penalty = t.shape > 0 ? 6 : 0; return true;
    case Kind::kResonance: c.coefficient_sign = 1, c.penalty = 12; return true;
    case Kind::kMissingViscous: case Kind::kMissingCoulomb: c.coefficient_sign = 1; return true;
    default: return true;
  }
  if (c.host < 0) return false;
  c.fixed = model[static_cast<size_t>(c.host)].known;
  return true;
}

// Friction near velocity reversals is known to some percent only: an effect beside it must bring more than that, or show
// with the reversals left out of account.
double CandidateBank::reversal_doubt(const std::vector<ActiveTerm>& model, const Term& t) const {
  double largest = 0;
  const auto& links = rows_.system().links;
  const auto touches = [&](const rig_file::Link& l, int dof) { return dof > 0 && (l.a == dof || l.b == dof); };
  for (const ActiveTerm& a : model) {
    const Term& own = a.term;
    if ((own.kind != Kind::kCoulomb && own.kind != Kind::kMissingCoulomb && own.kind != Kind::kStribeck) || !(a.std > 0)) continue;
    const rig_file::Link& l = links[static_cast<size_t>(own.link)];
    const bool near = t.dof >= 0 ? touches(l, t.dof + 1)
                                 : touches(l, links[static_cast<size_t>(t.link)].a) || touches(l, links[static_cast<size_t>(t.link)].b);
    if (near) largest = std::max(largest, std::pow(a.value / a.std, 2));
  }
  if (friction_shape(t.kind)) return 1e-4 * largest;
  return (rows_.reversals() == Rows::Reversals::kWide ? 1e-5 : 1e-3) * largest;
}

std::vector<Candidate> CandidateBank::beside(const std::vector<ActiveTerm>& model) const {
  Columns columns = columns_;
  for (const ActiveTerm& a : model) {  // a link that the rig file lacks may have more to it than its damper
    const bool damper = a.term.kind == Kind::kMissingViscous || a.term.kind == Kind::kMissingCoulomb;
    if (!damper || static_cast<size_t>(a.term.link) < rows_.system().known_links) continue;
    const Columns& more = effects_of_unlisted(a.term.link);
    columns.insert(columns.end(), more.begin(), more.end());
  }
  std::vector<Candidate> list;
  for (const auto& column : columns) {
    Candidate c;
    c.column = column;
    const auto partner = partner_.find(column.get());
    if (partner != partner_.end()) c.companions = partner->second, c.penalty = c.term().kind == Kind::kQuadraticStiffness ? 24 : 6;
    if (!prepare(model, c)) continue;
    // integrated motion drifts, and drift looks like much, most of all like a hidden mass with a spring of its own
    if (!rows_.absolute()) c.threshold *= c.term().kind == Kind::kResonance ? 80 : 4;
    else if (!rows_.redundant()) c.threshold *= friction_shape(c.term().kind) ? 6 : 2;  // noise that no second channel bears out
    c.threshold += reversal_doubt(model, c.term());
    list.push_back(c);
  }
  return list;
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
  if (t.kind == Kind::kQuadraticStiffness && !rows_.absolute()) also(Kind::kStiffnessError, -1);  // about a mean that is not known
  return list;
}

Candidate CandidateBank::reshaped(const Candidate& candidate, double shape, double shape2) const {
  Candidate c = candidate;
  Term t = candidate.term();
  t.shape = shape, t.shape2 = shape2;
  c.column = rows_.column(t);
  c.companions.clear();
  for (const Term& other : companions_of(t)) c.companions.push_back(rows_.column(other));
  return c;
}

Candidate CandidateBank::again(const Term& term, const std::vector<ActiveTerm>& model) const {
  Candidate c;
  c.column = std::make_shared<const Column>(Column{term, {}, 0, 0, 0});
  prepare(model, c);
  return reshaped(c, term.shape, term.shape2);
}

}  // namespace diagnosis
