// The first samples of a free motion.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace diagnosis {

// The records without what stands before the rig was let go: while it is held an accelerometer reads nought, and then all at once what
// the springs pull. No motion that is simulated jumps like that, and one such sample outweighs all that a decay is missed by. Looked
// for at the start of records that no force and no base drives; a jump is one that is twice as large as any behind it.
std::vector<host_sim::Record> from_release(std::vector<host_sim::Record> records);

// Whether there is anything to leave out.
bool any_begins_held(const std::vector<host_sim::Record>& records);

}  // namespace diagnosis
