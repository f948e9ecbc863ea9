// Where converters saturate, as their drivers tell it.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "hal/linux/iio/iio_channel.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace board {

// What a driver tells of a channel; nothing: its words' width is not known.
using DriverRange = std::function<std::optional<hal::CodeRange>(const hal::IioChannel&)>;

// Takes the rails of those channels whose board file does not say them, and plans the signals anew: what was planned for 24 bits
// would round the 12 of a converter to steps of four. Empty, or which channel's codes are out of reach of its offset_code.
std::string take_driver_rails(const std::vector<hal::IioChannel>& channels, const DriverRange& range,
                              firmware::CoreConfiguration& core, const rig_file::SignalRanges& told = {});

}  // namespace board
