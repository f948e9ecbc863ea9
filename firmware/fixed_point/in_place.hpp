// Whether small functions stand wherever they are used: on a PC, where a call takes longer than they do. On a board they stand once,
// for there flash counts.
#pragma once

#if defined(__x86_64__)
#define FIRMWARE_IN_PLACE
#define FIRMWARE_ONCE inline
#else
#define FIRMWARE_ONCE [[gnu::noinline]] inline
#endif
