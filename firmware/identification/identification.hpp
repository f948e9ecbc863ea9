// Least squares over the energy equations of all DOFs and levels (Eq. 20 to 22), weighted by their measured scatter.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

// Reads the table, writes estimates; all working memory is static inside the stage's own object.
void identify(const CoreConfiguration& configuration, const BatchTable& table, Estimates& estimates);

}  // namespace firmware
