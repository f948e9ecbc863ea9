// The configuration store on files: the old or the new content after a power loss at every single operation, never a
// mixture and never nothing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "firmware/configuration/bytes.hpp"
#include "hal/linux/store/file_configuration_store.hpp"
#include "hal/linux/store/posix_file_operations.hpp"
#include "tests/hal/power_cut_files.hpp"

namespace {

using hal::FileConfigurationStore;
using hal_test::Bytes;
using hal_test::Disk;
using hal_test::PowerCutFiles;

Bytes content(uint8_t first, size_t size) {
  Bytes bytes;
  for (size_t i = 0; i < size; ++i) bytes.push_back(static_cast<uint8_t>(first + 7 * i));
  return bytes;
}

Bytes loaded(hal::FileOperations& files) {
  FileConfigurationStore store(files);
  Bytes bytes(FileConfigurationStore::kCapacity);
  bytes.resize(store.load(bytes.data(), bytes.size()));
  return bytes;
}

bool save(hal::FileOperations& files, const Bytes& bytes) {
  return FileConfigurationStore(files).save(bytes.data(), bytes.size());
}

Disk saved(const Disk& before, const Bytes& bytes) {
  PowerCutFiles files(before);
  EXPECT_TRUE(save(files, bytes));
  return files.now();
}

// Cuts the power at every operation of a save and collects the disks that may be found then. Each must hold old or new.
std::vector<Disk> cut_everywhere(const Disk& before, const Bytes& old_content, const Bytes& new_content,
                                 int& operations) {
  std::vector<Disk> found;
  for (int cut = 0;; ++cut) {
    PowerCutFiles files(before);
    files.cut_at(cut);
    const bool done = save(files, new_content);
    EXPECT_EQ(done, !files.cut());
    for (const Disk& disk : files.after_power_loss()) {
      PowerCutFiles after(disk);
      const Bytes now = loaded(after);
      EXPECT_TRUE(now == new_content || (now == old_content && !done)) << "cut at operation " << cut;
      found.push_back(disk);
    }
    if (!files.cut()) {
      operations = files.operations();
      return found;
    }
  }
}

// The check value of CRC-32 as in zip: the CRC of the nine digits.
TEST(ConfigurationStore, CheckSumIsThatOfZip) {
  const char digits[] = "123456789";
  EXPECT_EQ(firmware::crc32(reinterpret_cast<const uint8_t*>(digits), 9), 0xCBF43926u);
}

TEST(ConfigurationStore, EmptyFolderHoldsNothing) {
  PowerCutFiles files({});
  EXPECT_TRUE(loaded(files).empty());
}

TEST(ConfigurationStore, LastSavedComesBack) {
  Disk disk;
  for (uint8_t i = 0; i < 7; ++i) {
    disk = saved(disk, content(i, 10u + i));
    PowerCutFiles files(disk);
    EXPECT_EQ(loaded(files), content(i, 10u + i)) << int(i);
  }
}

TEST(ConfigurationStore, PowerLossAtEveryOperationLeavesOldOrNew) {
  const Bytes one = content(1, 40), two = content(2, 40), three = content(3, 64), four = content(4, 8);
  int operations = 0, states = 0;
  // From an empty folder, from one generation, and from two.
  for (const Disk& before : {Disk{}, saved({}, one), saved(saved({}, two), one)}) {
    const Bytes old_content = before.empty() ? Bytes{} : one;
    for (const Disk& first : cut_everywhere(before, old_content, three, operations)) {
      // And again from everything that the first power loss may leave behind.
      PowerCutFiles files(first);
      const Bytes kept = loaded(files);
      states += static_cast<int>(cut_everywhere(first, kept, four, operations).size());
    }
  }
  EXPECT_EQ(operations, 5);  // create, write, sync, rename, sync of the folder: each was cut
  EXPECT_GT(states, 1000);
}

// The fake is strict enough to tell: the same save without syncing the file is caught.
TEST(ConfigurationStore, FakeDiskCatchesAMissingSync) {
  struct Careless final : hal::FileOperations {
    explicit Careless(PowerCutFiles& inner) : files(inner) {}
    bool create(const char* name) override { return files.create(name); }
    bool write(const uint8_t* bytes, size_t size) override { return files.write(bytes, size); }
    bool sync_file() override { return true; }
    bool close() override { return files.close(); }
    bool rename(const char* from, const char* to) override { return files.rename(from, to); }
    bool sync_folder() override { return files.sync_folder(); }
    size_t read(const char* name, uint8_t* bytes, size_t capacity) override {
      return files.read(name, bytes, capacity);
    }
    PowerCutFiles& files;
  };
  PowerCutFiles files(saved({}, content(1, 20)));
  Careless careless(files);
  EXPECT_TRUE(save(careless, content(2, 20)));
  int lost = 0;
  for (const Disk& disk : files.after_power_loss()) {
    PowerCutFiles after(disk);
    lost += loaded(after) != content(2, 20);
  }
  EXPECT_GT(lost, 0);
}

TEST(ConfigurationStore, EveryDamagedByteFallsBackToTheGenerationBefore) {
  const Disk disk = saved(saved({}, content(1, 30)), content(2, 30));
  ASSERT_EQ(disk.count("configuration.1"), 1u);
  const size_t size = disk.at("configuration.1").size();
  for (size_t i = 0; i < size; ++i) {
    Disk damaged = disk;
    damaged["configuration.1"][i] ^= 0x10;
    PowerCutFiles files(damaged);
    EXPECT_EQ(loaded(files), content(1, 30)) << "byte " << i;
  }
}

TEST(ConfigurationStore, RefusesWhatDoesNotFit) {
  PowerCutFiles files({});
  FileConfigurationStore store(files);
  const Bytes large(FileConfigurationStore::kCapacity + 1, 1);
  EXPECT_FALSE(store.save(large.data(), large.size()));
  EXPECT_FALSE(store.save(large.data(), 0));
  EXPECT_EQ(files.operations(), 0);
  EXPECT_TRUE(store.save(large.data(), 100));
  uint8_t small[99];
  EXPECT_EQ(store.load(small, sizeof small), 0u);
}

TEST(ConfigurationStore, TheLargestThatAnyoneMaySaveComesBack) {
  const Bytes largest = content(3, FileConfigurationStore::kCapacity);
  PowerCutFiles files(saved({}, largest));
  EXPECT_EQ(loaded(files), largest);
}

TEST(ConfigurationStore, WorksOnARealFolder) {
  char folder[] = "/tmp/store_test_XXXXXX";
  ASSERT_NE(mkdtemp(folder), nullptr);
  hal::PosixFileOperations files;
  ASSERT_EQ(files.open(std::string(folder) + "/state"), "");
  EXPECT_TRUE(loaded(files).empty());
  for (uint8_t i = 1; i < 5; ++i) {
    EXPECT_TRUE(save(files, content(i, 500)));
    hal::PosixFileOperations again;
    ASSERT_EQ(again.open(std::string(folder) + "/state"), "");
    EXPECT_EQ(loaded(again), content(i, 500));
  }
  EXPECT_NE(files.open(std::string(folder) + "/missing/state"), "");
  EXPECT_EQ(std::system(("rm -r " + std::string(folder)).c_str()), 0);
}

}  // namespace
