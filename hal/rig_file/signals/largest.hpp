// What a planned signal reaches on recorded samples.
#pragma once
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/configuration/configuration.hpp"

namespace rig_file {

// The signal's largest magnitude over one record, in SI and in double: as firmware/conditioning, without its rounding.
double largest_value(const firmware::CoreConfiguration& c, int node, int q,
                     const std::vector<firmware::RawSample>& record);

}  // namespace rig_file
