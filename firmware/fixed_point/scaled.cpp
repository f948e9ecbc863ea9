// Block-floating arithmetic: its steps, where they do not stand in place.
#include "firmware/fixed_point/scaled.hpp"

#include "firmware/fixed_point/scaled_steps.hpp"
