// What the rig's own model has, as the plan of the probes asks for it.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/vocabulary/effect_row.hpp"

namespace firmware {

class ModelTerms {
 public:
  explicit ModelTerms(const CoreConfiguration& configuration) : c_(configuration) {}
  // A link joins the two nodes.
  bool joined(int a, int b) const;
  // Some DOF is joined to both.
  bool share_a_neighbour(int a, int b) const;
  // Sign of the term's force in the DOF's equation of motion; 0: it does not stand there.
  int8_t sign_in(const Term& term, int dof) const;
  // The rig has such a term on this link, estimated or known.
  bool has_term(TermKind kind, int link) const;
  // The rig estimates a coefficient of this very force.
  bool estimated(const CoreTerm& core, int number) const;
  bool weighs(int dof) const;  // a mass is known or estimated there
  // Without one all coefficients take up a gain of the force, and what they leave of the force is the residual itself.
  bool known_term_in(int dof) const;
  // Where no force is measured and this is all that is known, motion tells ratios to it: whatever it is, the others go with it.
  bool sets_the_scale(TermKind kind, int number) const;
  // What is integrated settles after a level's start by itself.
  bool integrated(int node) const;

 private:
  const CoreConfiguration& c_;
};

}  // namespace firmware
