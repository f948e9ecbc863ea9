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

// Takes the rails of those channels whose board file does not say them, and plans the signals anew: slopes and integrals
// that were planned for 24 bits would have hardly any codes of a converter's 12. Empty, or which channel's codes are out of reach of its offset_code.
std::string take_driver_rails(const std::vector<hal::IioChannel>& channels, const DriverRange& range,
                              firmware::CoreConfiguration& core, const rig_file::SignalRanges& told = {});

// A line for each channel whose converter has more than the 24 bits of a code: what one of its codes is.
std::string wide_words(const std::vector<hal::IioChannel>& channels, const DriverRange& range);

}  // namespace board
