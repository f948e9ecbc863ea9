// Bytes of IIO buffers in layouts that real drivers have. Every value is worked out by hand from the bytes beside it.
#include "hal/linux/iio/iio_scan_format.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

struct Channel {
  std::string type;
  int offset;     // expected, in the scan
  int64_t value;  // expected, of each repeat
  std::vector<int64_t> repeats = {};
};

struct Layout {
  std::string name;
  std::vector<Channel> channels;  // by rising index
  std::vector<uint8_t> scan;
};

const std::vector<Layout> kLayouts = {
    // Three 16-bit unsigned channels, then the time stamp aligned to 8: 0x1234 = 4660, 0xFFFF = 65535, 0x8000 = 32768,
    // stamp 0x0102030405060708 = 72623859790382856. Six bytes of samples, two of filling.
    {"le:u16/16 and a time stamp",
     {{"le:u16/16>>0", 0, 4660},
      {"le:u16/16>>0", 2, 65535},
      {"le:u16/16>>0", 4, 32768},
      {"le:s64/64>>0", 8, 72623859790382856}},
     {0x34, 0x12, 0xFF, 0xFF, 0x00, 0x80, 0, 0, 8, 7, 6, 5, 4, 3, 2, 1}},
    // 12 bits left-aligned in 16, big-endian: 0xABC5 >> 4 = 0xABC = 2748 unsigned; signed 0xABC - 4096 = -1348; 0x7FF0
    // >> 4
    // = 2047. The low four bits hold other things (5, 0xF) and must vanish.
    {"be:12/16 with shift 4",
     {{"be:u12/16>>4", 0, 2748}, {"be:s12/16>>4", 2, -1348}, {"be:s12/16>>4", 4, 2047}},
     {0xAB, 0xC5, 0xAB, 0xCF, 0x7F, 0xF0}},
    // 24 bits in 32, big-endian, the low byte is the converter's status: 0x800000 = -8388608, 0x7FFFFF = 8388607,
    // 0xFFFFFF = -1; unsigned 0xFFFFFF = 16777215.
    {"be:24/32 with shift 8",
     {{"be:s24/32>>8", 0, -8388608},
      {"be:s24/32>>8", 4, 8388607},
      {"be:s24/32>>8", 8, -1},
      {"be:u24/32>>8", 12, 16777215}},
     {0x80, 0, 0, 0xA5, 0x7F, 0xFF, 0xFF, 0x5A, 0xFF, 0xFF, 0xFF, 0, 0xFF, 0xFF, 0xFF, 7}},
    // Four 32-bit elements of one channel (a quaternion): the whole is aligned to 16, so 14 bytes of filling follow the
    // 16-bit channel; values 1, -2, 65536, -65536. Scan size 32.
    {"le:s32/32X4 behind a 16-bit channel",
     {{"le:s16/16>>0", 0, -3}, {"le:s32/32X4>>0", 16, 1, {1, -2, 65536, -65536}}},
     {0xFD, 0xFF, 0, 0, 0,    0,    0,    0,    0, 0, 0, 0, 0, 0, 0,    0,
      1,    0,    0, 0, 0xFE, 0xFF, 0xFF, 0xFF, 0, 0, 1, 0, 0, 0, 0xFF, 0xFF}},
    // Mixed sizes: 8 bits at 0, 32 at 4, 16 at 8, and the scan rounded up to 12. -5; 0x00FEDCBA >> 4 in 20 bits =
    // 0xFEDCB =
    // 1043915 unsigned; 14 bits signed of 0xFFFC >> 2 = 0x3FFF = -1.
    {"mixed sizes",
     {{"le:s8/8", 0, -5}, {"le:u20/32>>4", 4, 1043915}, {"le:s14/16>>2", 8, -1}},
     {0xFB, 0, 0, 0, 0xBA, 0xDC, 0xFE, 0x00, 0xFC, 0xFF, 0, 0}},
};

TEST(IioScanFormat, RecordedBytes) {
  for (const Layout& layout : kLayouts) {
    hal::ScanLayout placed;
    for (const Channel& channel : layout.channels) {
      hal::ScanType type;
      ASSERT_TRUE(hal::parse_scan_type(channel.type, type)) << layout.name;
      const int offset = placed.add(type);
      EXPECT_EQ(offset, channel.offset) << layout.name << ", " << channel.type;
      const uint8_t* bytes = layout.scan.data() + offset;
      EXPECT_EQ(hal::decode_element(type, bytes), channel.value) << layout.name << ", " << channel.type;
      for (size_t i = 0; i < channel.repeats.size(); ++i)
        EXPECT_EQ(hal::decode_element(type, bytes + i * type.storage_bits / 8), channel.repeats[i]) << layout.name;
    }
    EXPECT_EQ(placed.size(), layout.scan.size()) << layout.name;
  }
}

TEST(IioScanFormat, TypeText) {
  hal::ScanType type;
  ASSERT_TRUE(hal::parse_scan_type("be:s12/16X3>>4\n", type));
  EXPECT_TRUE(type.big_endian);
  EXPECT_TRUE(type.is_signed);
  EXPECT_EQ(type.bits, 12);
  EXPECT_EQ(type.storage_bits, 16);
  EXPECT_EQ(type.repeat, 3);
  EXPECT_EQ(type.shift, 4);
}

TEST(IioScanFormat, RefusesTextThatIsNoType) {
  hal::ScanType type;
  for (const char* text :
       {"", "le", "le:", "xe:s12/16>>4", "le:f32/32>>0", "le:s12", "le:s12/", "le:s12/12>>0", "le:s0/16>>0",
        "le:s12/16>>5", "le:s17/16>>0", "le:s16/16X0>>0", "le:s16/16>>0 and more", "le:s999/16>>0"})
    EXPECT_FALSE(hal::parse_scan_type(text, type)) << text;
}

TEST(IioScanFormat, NoMoreElementsThanThereIsRoomFor) {
  hal::ScanLayout layout;
  hal::ScanType type;
  ASSERT_TRUE(hal::parse_scan_type("le:s16/16>>0", type));
  for (int i = 0; i < hal::kMaxScanElements; ++i) EXPECT_EQ(layout.add(type), 2 * i);
  EXPECT_EQ(layout.add(type), -1);
  EXPECT_EQ(layout.size(), 2u * hal::kMaxScanElements);
}

}  // namespace
