// Objects read and written over the bus, and the store behind "save" and "load".
#include <gtest/gtest.h>

#include <string>

#include "firmware/version.hpp"
#include "hal/fake/fake_worker.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;

constexpr uint8_t kRead = 0x40, kWrite2 = 0x2B, kWrite4 = 0x23, kAborted = 0x80, kWritten = 0x60;
constexpr uint32_t kSave = 0x65766173, kLoad = 0x64616F6C;

struct Number {
  uint16_t index;
  uint8_t subindex;
  uint8_t command;  // CiA 301: 4F one byte, 4B two, 43 four
  uint32_t value;
};

TEST(Sdo, NumbersReadAsTheStandardSays) {
  Bench bench(bench::listening());
  bench.step();
  const uint32_t crc = firmware::configuration_crc(bench.configuration);
  const Number numbers[] = {{0x1000, 0, 0x43, 0}, {0x1001, 0, 0x4F, 0},     {0x1005, 0, 0x43, 0x080},
                            {0x1010, 0, 0x4F, 1}, {0x1010, 1, 0x43, 1},     {0x1011, 0, 0x4F, 1},
                            {0x1011, 1, 0x43, 1}, {0x1014, 0, 0x43, 0x081}, {0x1017, 0, 0x4B, 100},
                            {0x1018, 0, 0x4F, 4}, {0x1018, 1, 0x43, 0},     {0x1018, 2, 0x43, 0},
                            {0x1018, 3, 0x43, 1}, {0x1018, 4, 0x43, crc}};
  for (const Number& number : numbers) {
    const auto reply = bench.sdo(kRead, number.index, number.subindex);
    ASSERT_TRUE(reply.came) << std::hex << number.index;
    EXPECT_EQ(reply.command, number.command) << std::hex << number.index << " " << int(number.subindex);
    EXPECT_EQ(reply.value, number.value) << std::hex << number.index << " " << int(number.subindex);
  }
}

std::string read_text(Bench& bench, uint16_t index) {
  auto reply = bench.sdo(kRead, index, 0);
  if (reply.command != 0x41) {  // short enough for one frame: 43 less four for each unused byte
    const int length = 4 - (reply.command >> 2 & 3);
    return std::string(reinterpret_cast<const char*>(reply.data + 4), static_cast<size_t>(length));
  }
  const uint32_t length = reply.value;
  std::string text;
  uint8_t command = 0x60;
  while (text.size() < length) {
    reply = bench.sdo(command, 0, 0);
    EXPECT_EQ(reply.command & 0x10, command & 0x10);  // the toggle comes back
    const int used = 7 - (reply.command >> 1 & 7);
    text.append(reinterpret_cast<const char*>(reply.data + 1), static_cast<size_t>(used));
    EXPECT_EQ((reply.command & 1) != 0, text.size() == length);
    command ^= 0x10;
    if (!reply.came || used == 0) break;
  }
  return text;
}

TEST(Sdo, TextsComeInSegments) {
  Bench bench(bench::listening());
  bench.step();
  EXPECT_EQ(read_text(bench, 0x1008), "rig_controller");  // 14 characters: two segments of seven
  EXPECT_EQ(read_text(bench, 0x1009), "any");
  EXPECT_EQ(read_text(bench, 0x100A), firmware::kVersionText);
}

TEST(Sdo, RefusalsCarryTheStandardsCodes) {
  Bench bench(bench::listening());
  bench.step();
  struct Refusal {
    uint8_t command;
    uint16_t index;
    uint8_t subindex;
    uint32_t value;
    uint32_t code;
  };
  const Refusal refusals[] = {
      {kRead, 0x2000, 0, 0, 0x06020000},                                             // no such object
      {kRead, 0x1018, 5, 0, 0x06090011},                                             // no such subindex
      {kRead, 0x1017, 1, 0, 0x06090011},       {kWrite4, 0x1000, 0, 1, 0x06010002},  // read only
      {kWrite4, 0x1017, 0, 50, 0x06070010},                                          // two bytes, not four
      {kWrite4, 0x1010, 1, 12345, 0x08000020},                                       // not "save"
      {kWrite4, 0x1011, 1, kSave, 0x08000020},                                       // "save" is not "load"
      {kWrite4, 0x3000, 0, 1, 0x06020000},     {0x60, 0, 0, 0, 0x05040001},          // a segment of nothing
      {0x21, 0x1017, 0, 2, 0x05040001},                                              // segmented write
      {0xC0, 0x1017, 0, 0, 0x05040001},                                              // block transfer
  };
  for (const Refusal& refusal : refusals) {
    const auto reply = bench.sdo(refusal.command, refusal.index, refusal.subindex, refusal.value);
    ASSERT_TRUE(reply.came);
    EXPECT_EQ(reply.command, kAborted) << std::hex << refusal.index;
    EXPECT_EQ(reply.value, refusal.code) << std::hex << refusal.index;
  }
}

TEST(Sdo, WrongToggleAborts) {
  Bench bench(bench::listening());
  bench.step();
  EXPECT_EQ(bench.sdo(kRead, 0x1008, 0).command, 0x41);
  const auto reply = bench.sdo(0x70, 0, 0);
  EXPECT_EQ(reply.command, kAborted);
  EXPECT_EQ(reply.value, 0x05030000u);
}

TEST(Sdo, RequestsToOtherNodesAreNotAnswered) {
  auto configuration = bench::listening();
  configuration.node.node = 2;
  Bench bench(configuration);
  bench.step();
  hal::CanFrame frame;
  frame.id = 0x601;
  frame.length = 8;
  frame.data[0] = kRead;
  frame.data[2] = 0x10;
  bench.can.inject(frame);
  bench.step();
  EXPECT_EQ(bench.can.count(0x581) + bench.can.count(0x582), 0u);
}

TEST(Sdo, HeartbeatTimeChangesAtOnceAndZeroSilencesIt) {
  Bench bench(bench::listening());
  bench.step();
  EXPECT_EQ(bench.sdo(kWrite2, 0x1017, 0, 20).command, kWritten);
  size_t beats = bench.can.count(0x701);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.count(0x701), beats + 50);
  EXPECT_EQ(bench.sdo(kWrite2, 0x1017, 0, 0).command, kWritten);
  beats = bench.can.count(0x701);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.count(0x701), beats);
}

TEST(Sdo, AHeartbeatThatWouldFillTheBusIsRefused) {
  Bench bench(bench::listening());
  bench.step();
  const auto reply = bench.sdo(kWrite2, 0x1017, 0, 9);
  EXPECT_EQ(reply.command, 0x80);
  EXPECT_EQ(reply.value, 0x06090030u);  // CiA 301: value range exceeded
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
  EXPECT_EQ(bench.sdo(kWrite2, 0x1017, 0, 10).command, kWritten);
}

// Written without its size (0x22) a value still has to fit: 0x10000 cut to 16 bits would be 0, which silences the node.
TEST(Sdo, AHeartbeatTimeBeyondItsSixteenBitsIsRefused) {
  Bench bench(bench::listening());
  bench.step();
  for (uint32_t value : {0x00010000u, 0x00010064u, 0xFFFF0000u}) {
    const auto reply = bench.sdo(0x22, 0x1017, 0, value);
    EXPECT_EQ(reply.command, kAborted);
    EXPECT_EQ(reply.value, 0x06090030u);
  }
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
  EXPECT_EQ(bench.sdo(0x22, 0x1017, 0, 50).command, kWritten);
}

// Writing may take longer than a sample period. CiA 301, 0x08000022: not in this device state.
TEST(Store, NothingIsSavedOrLoadedWhileDriving) {
  Bench bench(bench::driving());
  bench.step();
  bench.sdo(kWrite2, 0x1017, 0, 250);
  ASSERT_TRUE(bench.controller->start());
  bench.run_samples(10);
  for (const auto& [index, signature] : {std::pair(0x1010, kSave), std::pair(0x1011, kLoad)}) {
    const auto reply = bench.sdo(kWrite4, static_cast<uint16_t>(index), 1, signature);
    EXPECT_EQ(reply.command, 0x80);
    EXPECT_EQ(reply.value, 0x08000022u);
  }
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 250u);
  uint8_t stored[firmware::kConfigurationBytes];
  EXPECT_EQ(bench.store.load(stored, sizeof stored), 0u);
  bench.stop_line.pulse(0);
  bench.run_samples(2);
  EXPECT_EQ(bench.sdo(kWrite4, 0x1010, 1, kSave).command, kWritten);
}

TEST(Store, SavedHeartbeatSurvivesARestartLoadTakesItBack) {
  Bench bench(bench::listening());
  bench.step();
  bench.sdo(kWrite2, 0x1017, 0, 250);
  EXPECT_EQ(bench.sdo(kWrite4, 0x1010, 1, kSave).command, kWritten);
  bench.restart();
  bench.step();
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 250u);
  EXPECT_EQ(bench.sdo(kWrite4, 0x1011, 1, kLoad).command, kWritten);
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
  bench.restart();
  bench.step();
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
}

TEST(Store, UnsavedChangeIsGoneAfterARestart) {
  Bench bench(bench::listening());
  bench.step();
  bench.sdo(kWrite2, 0x1017, 0, 250);
  bench.restart();
  bench.step();
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
}

TEST(Store, AnEditedRigWinsOverWhatIsStored) {
  Bench bench(bench::listening());
  bench.step();
  bench.sdo(kWrite2, 0x1017, 0, 250);
  bench.sdo(kWrite4, 0x1010, 1, kSave);
  bench.configuration.core.terms[1].value = firmware::Scaled::from_int(20000);
  bench.restart();
  bench.step();
  EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 100u);
}

// The stored bytes, cut at every one of them, read back by a controller's own decoder.
TEST(Store, PowerLossAtEveryByteLeavesTheOldOrTheNew) {
  auto before = bench::listening(), after = bench::listening();
  before.node.heartbeat_ms = 150;
  after.node.heartbeat_ms = 350;
  static uint8_t old_bytes[firmware::kConfigurationBytes], new_bytes[firmware::kConfigurationBytes],
      loaded[firmware::kConfigurationBytes];
  const size_t old_size = encode(before, old_bytes), new_size = encode(after, new_bytes);
  int olds = 0, news = 0;
  for (size_t cut = 0; cut <= new_size + 16 && news < 2; ++cut) {
    hal::FakeConfigurationStore store;
    ASSERT_TRUE(store.save(old_bytes, old_size));
    store.cut_power_after(cut);
    const bool saved = store.save(new_bytes, new_size);
    const size_t size = store.load(loaded, sizeof loaded);
    firmware::ControllerConfiguration read;
    ASSERT_TRUE(decode(loaded, size, read)) << "cut after " << cut << " bytes";
    ASSERT_TRUE(read.node.heartbeat_ms == 150 || read.node.heartbeat_ms == 350) << cut;
    EXPECT_EQ(saved, read.node.heartbeat_ms == 350) << cut;
    (saved ? news : olds) += 1;
  }
  EXPECT_EQ(news, 2);  // only the whole write counts: generation and check sum are eight bytes more
  EXPECT_EQ(olds, static_cast<int>(new_size) + 8);
}

TEST(Store, ControllerStartsAfterAPowerLossWhileSaving) {
  static uint8_t bytes[firmware::kConfigurationBytes];
  const size_t size = encode(bench::listening(), bytes);
  for (size_t cut = 1; cut < size; cut += size / 7) {
    Bench bench(bench::listening());
    bench.step();
    bench.sdo(kWrite2, 0x1017, 0, 150);
    bench.sdo(kWrite4, 0x1010, 1, kSave);
    bench.sdo(kWrite2, 0x1017, 0, 350);
    bench.store.cut_power_after(cut);
    EXPECT_EQ(bench.sdo(kWrite4, 0x1010, 1, kSave).command, kAborted);
    bench.store.restore_power();
    bench.restart();
    bench.step();
    EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 150u) << cut;
  }
}

// A memory card that takes 300 ms while the rig is listened to: no step waits for it, the answer comes afterwards, and a
// second request meanwhile is told to come later.
TEST(Store, NoStepWaitsForASave) {
  for (const bool succeeds : {true, false}) {
    Bench bench(bench::listening());
    hal::FakeWorker worker;
    worker.takes(hal::FakeWorker::kUntilTold);
    bench.store_worker = &worker;
    bench.restart();
    bench.step();
    bench.sdo(kWrite2, 0x1017, 0, 250);
    if (!succeeds) bench.store.cut_power_after(10);
    EXPECT_FALSE(bench.sdo(kWrite4, 0x1010, 1, kSave).came);
    const uint32_t samples = bench.controller->core().health().samples;
    bench.run_samples(300);
    EXPECT_EQ(bench.controller->core().health().samples, samples + 300);
    EXPECT_EQ(bench.store.written_bytes(), 0u);
    EXPECT_EQ(bench.sdo(kWrite4, 0x1010, 1, kSave).value, 0x08000022u);
    EXPECT_EQ(bench.sdo(kRead, 0x1017, 0).value, 250u);
    EXPECT_EQ(worker.waits(), 0);
    const size_t replies = bench.can.count(0x581);
    worker.finish();
    bench.run_samples(2);
    ASSERT_EQ(bench.can.count(0x581), replies + 1);
    const hal::CanFrame& reply = *bench.can.last(0x581);
    EXPECT_EQ(reply.data[0], succeeds ? kWritten : kAborted);
    EXPECT_EQ(reply.data[1] | reply.data[2] << 8, 0x1010);
    bench.run_samples(120);
    EXPECT_EQ(bench.can.last(0x181)->data[1] >> 2 & 1, succeeds ? 0 : 1);  // status bit 10: STORE
  }
}

TEST(Store, TheLargestConfigurationIsSavedAndComesBack) {
  firmware::ControllerConfiguration largest = bench::listening();
  largest.core.dof_count = firmware::kMaxDofs;
  largest.core.link_count = firmware::kMaxLinks;
  largest.core.term_count = firmware::kMaxTerms;
  largest.programme.level_count = firmware::kMaxLevels;
  for (auto& node : largest.core.signals)
    for (auto& signal : node) signal.half_length = firmware::kFilterHalf;
  largest.node.heartbeat_ms = 250;
  static uint8_t bytes[firmware::kConfigurationBytes], loaded[firmware::kConfigurationBytes];
  const size_t size = encode(largest, bytes);
  EXPECT_GT(size, 8192u);
  hal::FakeConfigurationStore store;
  ASSERT_TRUE(store.save(bytes, size));
  ASSERT_EQ(store.load(loaded, sizeof loaded), size);
  firmware::ControllerConfiguration back;
  ASSERT_TRUE(decode(loaded, size, back));
  EXPECT_EQ(configuration_crc(back), configuration_crc(largest));
  EXPECT_FALSE(store.save(std::vector<uint8_t>(hal::ConfigurationStore::kCapacity + 1).data(),
                          hal::ConfigurationStore::kCapacity + 1));
}

TEST(Store, FailedSaveIsToldAndShown) {
  Bench bench(bench::listening());
  bench.step();
  bench.store.cut_power_after(10);
  const auto reply = bench.sdo(kWrite4, 0x1010, 1, kSave);
  EXPECT_EQ(reply.command, kAborted);
  bench.run_samples(120);
  EXPECT_TRUE(bench.can.last(0x181)->data[1] >> 2 & 1);  // status bit 10: STORE
  EXPECT_EQ(bench.can.last(0x081)->data[0] | bench.can.last(0x081)->data[1] << 8, 0x6310);
}

}  // namespace
