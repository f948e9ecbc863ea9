#include "firmware/warrant/probes/model_terms.hpp"

namespace firmware {

bool ModelTerms::joined(int a, int b) const {
  for (int l = 0; l < c_.link_count; ++l) {
    const LinkConfiguration& link = c_.links[l];
    if ((link.node_a == a && link.node_b == b) || (link.node_a == b && link.node_b == a)) return true;
  }
  return false;
}

bool ModelTerms::share_a_neighbour(int a, int b) const {
  for (int n = 0; n < c_.dof_count; ++n)
    if (joined(a, n) && joined(b, n)) return true;
  return false;
}

int8_t ModelTerms::sign_in(const Term& term, int dof) const {
  if (term.kind == TermKind::kMass) return static_cast<int8_t>(term.place == dof);
  const LinkConfiguration& link = c_.links[term.place];
  return static_cast<int8_t>((link.node_a == dof) - (link.node_b == dof));
}

bool ModelTerms::has_term(TermKind kind, int link) const {
  for (int t = 0; t < c_.term_count; ++t)
    if (c_.terms[t].kind == kind && c_.terms[t].place == link) return true;
  return false;
}

bool ModelTerms::estimated(const CoreTerm& core, int number) const {
  for (int t = 0; t < c_.term_count && core.estimable; ++t)
    if (c_.terms[t].unknown >= 0 && c_.terms[t].kind == core.term && c_.terms[t].place == number) return true;
  return false;
}

bool ModelTerms::weighs(int dof) const {
  for (int t = 0; t < c_.term_count; ++t) {
    const Term& term = c_.terms[t];
    if (term.kind == TermKind::kMass && term.place == dof && (term.unknown >= 0 || !term.value.is_zero())) return true;
  }
  return false;
}

bool ModelTerms::known_term_in(int dof) const {
  for (int t = 0; t < c_.term_count; ++t) {
    const Term& term = c_.terms[t];
    if (term.unknown < 0 && !term.value.is_zero() && sign_in(term, dof) != 0) return true;
  }
  return false;
}

bool ModelTerms::sets_the_scale(TermKind kind, int number) const {
  bool it_does = false;
  for (int t = 0; t < c_.term_count; ++t) {
    const Term& term = c_.terms[t];
    if (term.unknown >= 0 || term.value.is_zero()) continue;
    if (term.kind != kind || term.place != number) return false;
    it_does = true;
  }
  for (int i = 0; i < c_.dof_count; ++i)
    if (c_.signals[i][static_cast<int>(Quantity::kForce)].available) return false;
  return it_does;
}

bool ModelTerms::integrated(int node) const {
  return kDerivesSignals && node < c_.dof_count &&
         c_.signals[node][static_cast<int>(Quantity::kDisplacement)].integrations > 0;
}

}  // namespace firmware
