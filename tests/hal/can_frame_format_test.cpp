// Frames in the kernel's form. The expected words are written out from linux/can.h: bit 31 extended, 30 remote, 29
// error.
#include "hal/linux/can/can_frame_format.hpp"

#include <gtest/gtest.h>

namespace {

hal::CanFrame frame(uint32_t id, uint8_t length) {
  hal::CanFrame result;
  result.id = id;
  result.length = length;
  for (int i = 0; i < length; ++i) result.data[i] = static_cast<uint8_t>(0x10 + i);
  return result;
}

TEST(CanFrameFormat, ClassicFrame) {
  const hal::KernelCanFrame kernel = hal::to_kernel(frame(0x123, 3));
  EXPECT_EQ(kernel.size, 16u);
  EXPECT_EQ(kernel.frame.can_id, 0x123u);
  EXPECT_EQ(kernel.frame.len, 3);
  EXPECT_EQ(kernel.frame.data[2], 0x12);
  EXPECT_EQ(kernel.frame.data[3], 0);
}

TEST(CanFrameFormat, ExtendedRemoteAndErrorBits) {
  hal::CanFrame extended = frame(0x1ABCDEF5, 0);
  extended.extended = true;
  EXPECT_EQ(hal::to_kernel(extended).frame.can_id, 0x9ABCDEF5u);
  hal::CanFrame remote = frame(0x701, 1);
  remote.remote = true;
  EXPECT_EQ(hal::to_kernel(remote).frame.can_id, 0x40000701u);
  EXPECT_EQ(hal::to_kernel(remote).frame.data[0], 0);
  hal::CanFrame error = frame(0x40, 8);
  error.error = true;
  EXPECT_EQ(hal::to_kernel(error).frame.can_id, 0x20000040u);
}

TEST(CanFrameFormat, FdLengthsAreRoundedUpAndFilledWithZero) {
  hal::CanFrame fd = frame(0x2C1, 33);
  fd.fd = true;
  fd.flags = 1;
  const hal::KernelCanFrame kernel = hal::to_kernel(fd);
  EXPECT_EQ(kernel.size, 72u);
  EXPECT_EQ(kernel.frame.len, 48);
  EXPECT_EQ(kernel.frame.flags, 1);
  EXPECT_EQ(kernel.frame.data[32], 0x30);
  EXPECT_EQ(kernel.frame.data[33], 0);
}

TEST(CanFrameFormat, ThereAndBack) {
  for (const bool extended : {false, true})
    for (const bool fd : {false, true})
      for (const uint8_t length : {uint8_t{0}, uint8_t{1}, uint8_t{8}}) {
        hal::CanFrame out = frame(0x155, length), back;
        out.extended = extended;
        out.fd = fd;
        const hal::KernelCanFrame kernel = hal::to_kernel(out);
        ASSERT_TRUE(hal::from_kernel(kernel.frame, kernel.size, back));
        EXPECT_EQ(back.id, out.id);
        EXPECT_EQ(back.extended, extended);
        EXPECT_EQ(back.fd, fd);
        EXPECT_EQ(back.length, length);
        EXPECT_EQ(std::vector<uint8_t>(back.data, back.data + 64), std::vector<uint8_t>(out.data, out.data + 64));
      }
}

TEST(CanFrameFormat, ErrorFrameKeepsItsClassAndNothingElse) {
  canfd_frame kernel{};
  kernel.can_id = 0x20000040;  // bus-off
  kernel.len = 8;
  hal::CanFrame back;
  ASSERT_TRUE(hal::from_kernel(kernel, 16, back));
  EXPECT_TRUE(back.error);
  EXPECT_FALSE(back.extended);
  EXPECT_EQ(back.id, 0x40u);
}

TEST(CanFrameFormat, RefusesWhatIsNoFrame) {
  canfd_frame kernel{};
  hal::CanFrame back;
  EXPECT_FALSE(hal::from_kernel(kernel, 15, back));
  kernel.len = 9;
  EXPECT_FALSE(hal::from_kernel(kernel, 16, back));
  EXPECT_TRUE(hal::from_kernel(kernel, 72, back));
  kernel.len = 65;
  EXPECT_FALSE(hal::from_kernel(kernel, 72, back));
}

}  // namespace
