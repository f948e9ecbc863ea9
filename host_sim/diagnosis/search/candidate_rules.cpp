// Which candidates make sense beside a model.
#include <algorithm>
#include <cmath>

#include "candidates.hpp"

namespace diagnosis {
namespace {

bool is_stiffness(Kind kind) { return kind == Kind::kStiffness; }
bool is_friction(Kind kind) { return kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb; }

// What the model has of a kind at the place of a term.
double present(const std::vector<ActiveTerm>& model, Kind kind, const Term& t) {
  double sum = 0;
  for (const ActiveTerm& a : model)
    if (a.term.kind == kind && a.term.link == t.link && a.term.dof == t.dof) sum += a.value;
  return std::abs(sum);
}

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

bool CandidateBank::has_shape(const Term& t) {
  const Kind kind = t.kind;
  return (kind == Kind::kDriftingViscous && t.shape > 0) || kind == Kind::kBacklash || kind == Kind::kEndStop ||
         kind == Kind::kResonance || friction_shape(kind);
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

// A wrong mass that nothing but a known spring (or the like) speaks against: its rival, that this is wrong, is asked for in its place.
bool CandidateBank::shows_as_rival(const std::vector<ActiveTerm>& model, const Term& t) const {
  if (t.kind != Kind::kMassError) return false;
  return std::any_of(model.begin(), model.end(), [](const ActiveTerm& a) {
    return !a.added && a.known && a.value != 0 && a.term.kind != Kind::kMass;
  });
}

std::vector<Term> CandidateBank::unseen(const std::vector<ActiveTerm>& model) const {
  std::vector<Term> list;
  for (const auto& column : columns_)
    if (!observable(model, column->term) && !shows_as_rival(model, column->term)) list.push_back(column->term);
  return list;
}

std::vector<Candidate> CandidateBank::seen_as_rivals(const std::vector<ActiveTerm>& model) const {
  std::vector<Candidate> list;
  for (const auto& column : columns_) {
    Candidate c;
    c.column = column;
    if (observable(model, column->term) || !shows_as_rival(model, column->term) || !prepare(model, c)) continue;
    c.threshold = c.threshold * strictness(c.term().kind) + reversal_doubt(model, c.term());
    list.push_back(c);
  }
  return list;
}

bool CandidateBank::prepare(const std::vector<ActiveTerm>& model, Candidate& c) const {
  const Term& t = c.term();
  c.threshold = threshold_;
  bool beside_known = false;  // a damper or a friction that the rig file states: it may be too large as well
  for (const ActiveTerm& a : model) {
    const Term& other = a.term;
    if (other.same_place(t)) return false;
    if (other.link == t.link && t.link >= 0) {
      const bool corrects = (t.kind == Kind::kMissingViscous && other.kind == Kind::kViscous) ||
                            (t.kind == Kind::kMissingCoulomb && other.kind == Kind::kCoulomb);
      if (corrects && !a.known) return false;
      beside_known = beside_known || corrects;
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
    case Kind::kStribeck:
      c.coefficient_sign = 1, c.penalty = 6, c.threshold = 100;
      return true;
    case Kind::kEndStop:
      c.coefficient_sign = 1, c.penalty = 6;
      return true;
    case Kind::kForceDelay:
      for (const FusedRecord& f : rows_.records()) c.doubt = std::max(c.doubt, f.hold_doubt_s);
      return true;
    case Kind::kDriftingViscous:
      c.penalty = t.shape > 0 ? 6 : 0;
      return true;
    case Kind::kMassError:
      c.doubt = kKnownElastic * present(model, Kind::kMass, t);
      return true;
    case Kind::kStiffnessError:
      c.doubt = kKnownElastic * present(model, Kind::kStiffness, t);
      return true;
    case Kind::kResonance:
      c.doubt = kKnownElastic * present(model, Kind::kMass, t);
      c.coefficient_sign = 1, c.penalty = 12;
      return true;
    case Kind::kMissingViscous:
    case Kind::kMissingCoulomb:
      c.coefficient_sign = beside_known ? 0 : 1;
      return true;
    default:
      return true;
  }
  if (c.host < 0) return false;
  c.fixed = model[static_cast<size_t>(c.host)].known;
  return true;
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
    if (partner != partner_.end())
      c.companions = partner->second, c.penalty = c.term().kind == Kind::kQuadraticStiffness ? 24 : 6;
    if (!observable(model, c.term()) || !prepare(model, c)) continue;
    c.threshold = c.threshold * strictness(c.term().kind) + reversal_doubt(model, c.term());
    list.push_back(c);
  }
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
  if (observable(model, term)) prepare(model, c);
  return reshaped(c, term.shape, term.shape2);
}

}  // namespace diagnosis
