// The moves of the search from one fitted model to another.
#pragma once
#include <optional>
#include <vector>

#include "scoring.hpp"

namespace diagnosis {

// What another term must bring beside the shape of friction, which near reversals is known to a few percent only.
constexpr double kLeastBesideFriction = 0.04;

struct State {  // a model, fitted
  std::vector<ActiveTerm> model;
  Fit fit;
};

// Indices of the terms that are not in the rig file.
std::vector<size_t> added_terms(const std::vector<ActiveTerm>& model);

class Moves {
 public:
  Moves(Rows& rows, const CandidateBank& bank) : rows_(rows), bank_(bank) {}
  State settled(std::vector<ActiveTerm> model, int rounds);
  // The state without one added term, under the weights of the state itself.
  State without(const State& state, size_t index);
  // Shapes of the added terms, each with the others in place.
  void polish(State& state);
  // The shape of friction, which moves the friction held near reversals: by the cost of whole fits.
  void settle_friction_shapes(State& state);
  // The best of the leading candidates once each is fitted and shaped in full.
  bool extend(State& state, double least_gain, size_t beam);
  // The best candidate that shows away from velocity reversals, where little else disturbs it.
  bool extend_beside_reversals(State& state, double least_gain);
  // What an added term brings where velocity reversals count for little, and what it must bring there.
  bool holds_beside_reversals(const State& state, size_t index);
  // One round of exchanging each added term for the best in its place. True if a term changed.
  bool swap(State& state);
  // Two terms may stand for one that was passed over when it was their first's turn. True if one took their place.
  bool merge(State& state);

 private:
  void polish_together(State& state);
  // The state with other shapes of a term, settled; none where they are out of range or not plausible.
  std::optional<State> reshaped(const State& state, size_t index, const Term& shapes);
  void settle_friction_shape(State& state, size_t index, Axis axis);
  bool merge_pair(State& state, size_t first, size_t second);
  bool extend_wide(State& state, double least_gain);
  bool holds_wide(const State& state, size_t index);
  Rows& rows_;
  const CandidateBank& bank_;
};

}  // namespace diagnosis
