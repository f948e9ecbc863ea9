#include "firmware/identification/estimate.hpp"

namespace firmware {

void clear(Warrant& warrant) { warrant = Warrant{}; }

void clear(Estimates& estimates) { estimates = Estimates{}; }

}  // namespace firmware
