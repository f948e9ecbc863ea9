// Keys: what is sent, what is asked first, what a log refuses.
#include "host_sim/live/terminal/controls.hpp"

#include <gtest/gtest.h>

namespace live {
namespace {

firmware::NetworkCommand command_of(const firmware::CanFrame& message) {
  firmware::NetworkCommand command;
  EXPECT_TRUE(firmware::unpack_network_command(message, command));
  return command;
}

TEST(Controls, TheWindowKeySendsSyncAtOnce) {
  Controls controls(true);
  const auto message = controls.press('w', {1});
  ASSERT_TRUE(message.has_value());
  EXPECT_TRUE(firmware::is_sync(*message));
}

TEST(Controls, StartStopAndResetAskFirst) {
  const std::pair<char, firmware::NetworkCommandCode> keys[] = {{'s', firmware::NetworkCommandCode::kStart},
                                                                {'x', firmware::NetworkCommandCode::kStop},
                                                                {'r', firmware::NetworkCommandCode::kReset}};
  for (const auto& [key, code] : keys) {
    Controls controls(true);
    controls.follow({3});
    EXPECT_FALSE(controls.press(key, {3}).has_value());
    EXPECT_TRUE(controls.asks());
    EXPECT_NE(controls.prompt().find("node 3?"), std::string::npos) << controls.prompt();
    EXPECT_FALSE(controls.press('n', {3}).has_value());
    EXPECT_FALSE(controls.asks());
    EXPECT_NE(controls.prompt().find("not sent"), std::string::npos);
    for (const char yes : {'y', key}) {  // the same key again says yes too
      controls.press(key, {3});
      const auto message = controls.press(yes, {3});
      ASSERT_TRUE(message.has_value()) << key << yes;
      EXPECT_EQ(command_of(*message).command, code);
      EXPECT_EQ(command_of(*message).node, 3);
    }
  }
}

// Any other key is a no: nothing that moves a rig is sent by a slip.
TEST(Controls, NothingButYesSends) {
  for (int key = 0; key < 300; ++key) {
    if (key == 'y' || key == 'Y' || key == 's') continue;
    Controls controls(true);
    controls.press('s', {1});
    EXPECT_FALSE(controls.press(key, {1}).has_value()) << key;
    EXPECT_FALSE(controls.asks());
  }
}

TEST(Controls, ALogTakesNoCommands) {
  Controls controls(false);
  for (const char key : {'w', 's', 'x', 'r'}) {
    EXPECT_FALSE(controls.press(key, {1}).has_value());
    EXPECT_FALSE(controls.asks());
    EXPECT_NE(controls.prompt().find("only an interface"), std::string::npos);
  }
}

TEST(Controls, TabGoesFromNodeToNode) {
  Controls controls(true);
  controls.follow({2, 5, 7});
  EXPECT_EQ(controls.node(), 2);
  controls.press('\t', {2, 5, 7});
  EXPECT_EQ(controls.node(), 5);
  controls.follow({1, 2, 5, 7});  // another one is heard: the choice stays
  EXPECT_EQ(controls.node(), 5);
  controls.press('\t', {2, 5, 7});
  controls.press('\t', {2, 5, 7});
  EXPECT_EQ(controls.node(), 2);
}

TEST(Controls, QuitsByQAndByControlC) {
  for (const int key : {static_cast<int>('q'), 3}) {
    Controls controls(true);
    controls.press(key, {});
    EXPECT_TRUE(controls.quit());
  }
  Controls asked(true);
  asked.press('s', {1});
  EXPECT_FALSE(asked.press(3, {1}).has_value());
  EXPECT_TRUE(asked.quit());
}

TEST(Controls, ScrollsWithinTheTable) {
  Controls controls(false);
  controls.press(kKeyUp, {});
  EXPECT_EQ(controls.first_row(), 0);
  controls.press(kKeyPageDown, {});
  controls.limit_rows(5);
  EXPECT_EQ(controls.first_row(), 5);
  controls.press(kKeyUp, {});
  EXPECT_EQ(controls.first_row(), 4);
}

}  // namespace
}  // namespace live
