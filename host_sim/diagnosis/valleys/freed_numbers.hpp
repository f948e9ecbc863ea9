// Masses and springs of a rig file as unknowns of a fit.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// Whether a term is freed: a mass (where a force gives the scale) or a spring of the rig file, or what it may lack.
bool may_be_wrong(const ModelTerm& term, bool scale);

// The rig file's terms, and springs and dampers of no size where it has no link.
Model with_missing_links(const Task& task, Model model);

// A number of the rig file and what the recording says of it.
struct Freed {
  size_t term = 0;
  double given = 0, found = 0, std = 0;
  double size = 0;  // of which a share is material
  double off() const { return found - given; }
  bool by_much() const;  // by half of it or more
  bool wrong() const;    // beyond chance and calibration
};

// s: the rig with its freed numbers fitted. What is not off goes back to its number in the rig file (`given`), and the others are
// fitted again beside it. Returns those that are off; none where the fit does not converge.
std::vector<Freed> wrong_numbers(const Task& task, const Model& given, State& s);

}  // namespace diagnosis::runs
