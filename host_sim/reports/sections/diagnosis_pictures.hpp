// The pictures of the diagnosis page.
#pragma once
#include <cstddef>
#include <vector>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/figures/plot.hpp"

namespace host_sim::reports {

// Columns of a curve: fewer where there are many pictures, so that the page stays small.
size_t picture_columns(size_t dofs);

// A detail where the rig as given is most wrong, the errors over the whole record, and the spectra.
std::vector<Plot> waveform_pictures(const DofView& view, const Waveform& waveform, size_t columns);

// Energies by term, and what is left over. all_terms: the names of the terms of every DOF of the page, so that a name
// has one colour on all of it.
std::vector<Plot> energy_pictures(const DofView& view, const std::vector<std::string>& all_terms, size_t columns);
std::vector<std::string> energy_terms(const std::vector<DofView>& views);

// Unexplained force against elongation, rate and time.
std::vector<Plot> link_pictures(const LinkView& link);

}  // namespace host_sim::reports
