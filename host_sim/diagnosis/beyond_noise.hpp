// The search for rigs whose residual stays far above sensor noise whatever is named: real ones. There the equation error
// is weighed by what no effect of the vocabulary explains, and effects are chosen by the free-running simulation.
#pragma once
#include "judge.hpp"
#include "search.hpp"

namespace diagnosis {

// Last row bin worth using where a model is far from the data: ten times the frequency that holds 99 % of the motion.
Eigen::Index end_of_motion(const FusedRecord& record);

// Widens the rows' covariance to what the whole vocabulary together leaves over.
void colour_by_vocabulary(Rows& rows, const CandidateBank& bank);

// From coloured rows of the training data. Models are tuned by simulating these data. A term is named that takes a quarter
// or more off the simulation's error both there and on the judge's unseen data, where it does best of all.
SearchResult search_by_simulation(Rows& rows, const CandidateBank& bank, const Judge& judge);

// The same terms, fitted to other rows of the same rig.
SearchResult transferred(const SearchResult& found, Rows& rows, const CandidateBank& bank);

// Chi-squared per degree of freedom of a model's terms, fitted to rows that sensor noise weighs.
double misfit(Rows& rows, const std::vector<ActiveTerm>& model);

}  // namespace diagnosis
