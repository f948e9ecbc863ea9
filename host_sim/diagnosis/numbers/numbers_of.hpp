// The numbers of a fitted model as they are told: names, units, standard deviations.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {

// A model's terms as the words and units of terms are kept, with what a fit found of them (empty: nothing). A backlash and what acts in
// another's place have that one's coefficient.
std::vector<ActiveTerm> fitted_terms(const Model& model, const std::vector<Determined>& found);
// "link 1-2", "dof 3", "channel displacement_2_m".
std::string place_of_term(const Task& task, const Term& term);
// The contract's word and place of a term.
NamedPlace named_place(const Task& task, const Term& term);
// Adds it to the equals of what is named, once.
void list_equal(const NamedPlace& place, Diagnosis& d);
// Of one of these terms; of all that are unknown or added.
std::vector<diagnosis::Parameter> parameters_of_cause(const Task& task, const std::vector<ActiveTerm>& terms,
                                                      const ActiveTerm& term);
std::vector<diagnosis::Parameter> all_parameters(const Task& task, const std::vector<ActiveTerm>& terms);

// The coefficients of a fit of free runs: its standard deviations come from the scatter of what is left, window by
// window.
std::vector<diagnosis::Parameter> numbers_of(const Task& task, const State& fitted);
// Names and values alone.
std::vector<diagnosis::Parameter> values_of(const Task& task, const Model& model);
// Two estimates of one number that differ by more than both allow. That of the rows then carries the noise of the
// motion.
bool contradicts(const diagnosis::Parameter& rows, const diagnosis::Parameter& runs);
// Of a sensor's fault: rows see a delay all over the band, runs beside friction.
bool of_sensor(const diagnosis::Parameter& p);
// Widens the rows' intervals to those of the runs. values_too: the runs' numbers stand, but for those of sensors.
void take_numbers(const std::vector<diagnosis::Parameter>& runs, bool values_too,
                  std::vector<diagnosis::Parameter>& parameters);

}  // namespace diagnosis::runs
