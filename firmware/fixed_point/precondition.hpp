// What a function of the core relies on. Checked where FIRMWARE_CHECKS is defined: on a PC, so in host_sim and in every
// test. A breach ends the program at once, before a wrong number can leave it. On a board nothing is checked: there a
// wrong number is less than a rig that nobody watches.
#pragma once

#ifdef FIRMWARE_CHECKS
#define FIRMWARE_PRECONDITION(condition) ((condition) ? static_cast<void>(0) : __builtin_trap())
#else
#define FIRMWARE_PRECONDITION(condition) static_cast<void>(0)
#endif
