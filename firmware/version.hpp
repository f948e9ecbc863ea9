// The firmware's version, as the identity frame and object 1018 tell it. Kept in step with project(VERSION) in CMakeLists.txt
// (tests/footprint compares them).
#pragma once
#include <cstdint>

namespace firmware {

constexpr uint8_t kVersionMajor = 0;
constexpr uint8_t kVersionMinor = 1;
constexpr uint8_t kVersionPatch = 0;
constexpr char kVersionText[] = "0.1.0";

}  // namespace firmware
