// What can be said of GPIO lines without a chip: names, and answers where there is none. Edges and levels are tested on
// the emulated boards (tests/board).
#include "hal/linux/gpio_line.hpp"

#include <gtest/gtest.h>

#include "hal/linux/line_name.hpp"

namespace {

TEST(LineName, ChipAndOffsetOrName) {
  EXPECT_EQ(hal::parse_line_name("gpiochip1:17").chip, "gpiochip1");
  EXPECT_EQ(hal::parse_line_name("gpiochip1:17").offset, 17u);
  for (const char* name :
       {"emergency_stop", "gpiochip0", "gpiochip0:", "gpiochip0:x", "gpiochip0:1x", "J3:5", "gpiochip0:1234567"}) {
    EXPECT_EQ(hal::parse_line_name(name).chip, "") << name;
    EXPECT_EQ(hal::parse_line_name(name).name, name);
  }
}

TEST(GpioLine, AMissingLineIsNamed) {
  hal::GpioInput input;
  hal::GpioOutput output;
  EXPECT_NE(input.open("no_such_line", {}).find("\"no_such_line\""), std::string::npos);
  EXPECT_NE(output.open("gpiochip99:3", {}).find("\"gpiochip99:3\""), std::string::npos);
}

TEST(GpioLine, AStopLineThatCannotBeReadCountsAsPressed) {
  hal::GpioInput input;
  hal::LineEdge edge;
  EXPECT_TRUE(input.active());
  EXPECT_FALSE(input.next_edge(edge));
  EXPECT_EQ(input.descriptor(), -1);
  hal::GpioOutput output;
  EXPECT_FALSE(output.set(true));
}

}  // namespace
