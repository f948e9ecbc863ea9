// How often the program has asked for memory since its start.
#pragma once

namespace footprint {

unsigned long long allocation_count();

}  // namespace footprint
