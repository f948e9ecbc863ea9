// The excitation programme of a board's file: [drive] limits and [[excitation.level]], in seconds, hertz and fractions
// of the amplifier's full scale, to the controller's integers.
#pragma once
#include <toml++/toml.h>

#include <string>

#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/linux/board/toml_section.hpp"

namespace board {

// Also chooses the window: whole cycles where all levels are sines of one frequency (or cycle_Hz, if not 0, says that
// the rig is driven so from elsewhere), free decay where all are, arbitrary intervals otherwise. controller.core is
// compiled.
void read_excitation(const std::string& file, const toml::table& root, const Section& drive, double rate_Hz,
                     double cycle_Hz, firmware::ControllerConfiguration& controller);

}  // namespace board
