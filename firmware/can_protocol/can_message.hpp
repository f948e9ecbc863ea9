// The former place of a frame, for what still includes it.
#pragma once
#include "firmware/can_protocol/can_frame.hpp"
