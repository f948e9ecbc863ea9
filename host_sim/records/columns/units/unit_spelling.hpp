// One spelling of a unit for all that are usual.
#pragma once
#include <string>
#include <string_view>

namespace host_sim {

// "(m/s^2)" as "m/s2", "µm" as "um": signs of UTF-8 and Latin-1 as letters, without what says nothing.
std::string plain_spelling(std::string_view text);

}  // namespace host_sim
