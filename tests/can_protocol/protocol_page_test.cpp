// docs/can_protocol.md: its tables are those of the frame table, and what it works out by hand is right.
#include "host_sim/can_log/protocol_page.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/can_protocol/load/bus_load.hpp"
#include "host_sim/can_log/decode.hpp"

namespace can_log {
namespace {

std::string committed_page() {
  std::ifstream file(std::string(RIG_SOURCE_DIR) + "/docs/can_protocol.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(ProtocolPage, IsUpToDate) {
  const std::string page = committed_page();
  ASSERT_FALSE(page.empty());
  EXPECT_EQ(page, renewed_page(page)) << "renew it: build/host/bin/can_protocol_page docs/can_protocol.md";
}

TEST(ProtocolPage, NamesEveryFrameAndSignal) {
  const std::string page = committed_page();
  for (const firmware::can::FrameDescription* frame : firmware::can::kFrames) {
    EXPECT_NE(page.find("### `" + std::string(frame->name) + "`"), std::string::npos) << frame->name;
    for (int i = 0; i < frame->signal_count; ++i)
      EXPECT_NE(page.find("| `" + std::string(frame->signals[i].name) + "` |"), std::string::npos);
  }
}

TEST(ProtocolPage, WithoutMarkersNothingIsRenewed) {
  EXPECT_EQ(renewed_page("# A page\n"), "");
  EXPECT_EQ(renewed_page(std::string(kGeneratedEnd) + kGeneratedBegin), "");
}

// The frames that the page reads by hand say what the page says they do.
TEST(ProtocolPage, ItsExampleDecodes) {
  const std::string page = committed_page();
  ASSERT_NE(page.find("    410#C06837770C301072 "), std::string::npos);
  ASSERT_NE(page.find("    681#000502010200 "), std::string::npos);
  std::istringstream input("(1.0) can0 681#000502010200\n(1.1) can0 410#C06837770C301072\n");
  std::ostringstream output, messages;
  decode(input, output, messages);
  EXPECT_NE(output.str().find("viscous[1-2]   = 20.0012 N s/m"), std::string::npos) << output.str();
}

TEST(BusLoad, ByHand) {
  using namespace firmware::can;
  // 8 bytes: 1 + 11 + 1 + 1 + 1 + 4 + 64 + 15 = 98 bits that may be stuffed, 97 / 4 = 24 at the most, and 1 + 2 + 7 +
  // 3: 135.
  EXPECT_EQ(classic_bits(8), 135);
  EXPECT_EQ(classic_bits(0), 47 + 8);  // 33 / 4
  // 49 frames of 135 bits in 50 ms at 500 kbit/s: 6615 of 25000 bits = 26.46 %, so under 30 %.
  EXPECT_EQ(load_permille(kEstimate, 49, 50000, 500000), 265);
  // One DOF at 1 kHz, 500 kbit/s: 135 of 500 bits.
  EXPECT_EQ(load_permille(kSensorMotion16, 1, 1000, 500000), 270);
}

}  // namespace
}  // namespace can_log
