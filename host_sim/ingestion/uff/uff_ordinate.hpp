// The format's table of ordinate types (specific data type of record 9 of dataset 58).
#pragma once
#include <optional>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim::uff {

const char* ordinate_word(int type);
// That is used; nothing for others.
std::optional<firmware::Quantity> quantity_of(int ordinate_type);

}  // namespace host_sim::uff
