// GPIO lines: names, answers where there is no chip, and on the emulated board (tests/board) levels of a real line.
// Edges come from outside the board: tests/board/guest/stop.sh.
#include "hal/linux/gpio/gpio_line.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "hal/linux/gpio/line_name.hpp"

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

// What the kernel says of the line that the emulated board's device tree calls "sync"; empty where there is none.
std::string kernel_says() {
  std::ifstream lines("/sys/kernel/debug/gpio");
  for (std::string text; std::getline(lines, text);)
    if (text.find("(sync ") != std::string::npos) return text;
  return "";
}
bool kernel_says(const char* word) { return kernel_says().find(word) != std::string::npos; }

class OnLine : public testing::Test {
 protected:
  void SetUp() override {
    if (kernel_says().empty()) GTEST_SKIP() << "this machine has no line \"sync\"";
  }
};

TEST_F(OnLine, OutputStartsInactiveAndFollows) {
  hal::GpioLine line;
  ASSERT_EQ(line.request_output("sync", {}), "");
  EXPECT_TRUE(kernel_says("rig_controller")) << kernel_says();
  EXPECT_TRUE(kernel_says("out lo")) << kernel_says();
  EXPECT_TRUE(line.set(true));
  EXPECT_TRUE(kernel_says("out hi")) << kernel_says();
  EXPECT_EQ(line.get(), 1);
  EXPECT_EQ(line.descriptor(), -1);
}

TEST_F(OnLine, AnActiveLowOutputIsHighUntilItIsSet) {
  hal::GpioLine line;
  hal::LineOptions options;
  options.active_low = true;
  ASSERT_EQ(line.request_output("sync", options), "");
  EXPECT_TRUE(kernel_says("out hi")) << kernel_says();
  EXPECT_TRUE(line.set(true));
  EXPECT_TRUE(kernel_says("out lo")) << kernel_says();
  EXPECT_TRUE(line.set(false));
  EXPECT_TRUE(kernel_says("out hi")) << kernel_says();
}

TEST_F(OnLine, AnActiveLowInputIsActiveWhereAPlainOneIsNot) {
  hal::LineOptions options;
  for (const bool active_low : {false, true}) {
    options.active_low = active_low;
    hal::GpioInput input;
    ASSERT_EQ(input.open("sync", options), "");
    ASSERT_NE(kernel_says(" hi"), kernel_says(" lo")) << kernel_says();
    EXPECT_EQ(input.active(), kernel_says(active_low ? " lo" : " hi")) << kernel_says();
    EXPECT_GE(input.descriptor(), 0);
    hal::LineEdge edge;
    EXPECT_FALSE(input.next_edge(edge));
  }
}

TEST_F(OnLine, ALineInUseIsRefusedUntilItIsLetGo) {
  hal::GpioInput other;
  {
    hal::GpioOutput holder;
    ASSERT_EQ(holder.open("sync", {}), "");
    EXPECT_NE(other.open("sync", {}).find("\"sync\" cannot be an input"), std::string::npos);
  }
  EXPECT_EQ(other.open("sync", {}), "");
}

}  // namespace
