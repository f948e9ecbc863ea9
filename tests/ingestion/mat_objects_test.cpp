// MAT files that hold objects of MATLAB's classes: made by hand, byte by byte, as no library writes them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

#include "host_sim/ingestion/mat/mat_reader.hpp"
#include "tests/ingestion/rigs.hpp"

namespace {

using test_rigs::dampers;
using test_rigs::expect_says;
using test_rigs::refusal;

std::string words(std::initializer_list<uint32_t> values) {
  std::string out;
  for (const uint32_t value : values)
    for (int byte = 0; byte < 4; ++byte) out += static_cast<char>(value >> (8 * byte) & 0xFF);
  return out;
}

// An element of a MAT file of version 5: type, length, and the bytes up to a whole eight.
std::string element(uint32_t type, const std::string& bytes) {
  return words({type, static_cast<uint32_t>(bytes.size())}) + bytes + std::string((8 - bytes.size() % 8) % 8, '\0');
}

constexpr uint32_t kInt8 = 1, kInt32 = 5, kUint32 = 6, kDouble = 9, kMatrix = 14;
constexpr uint32_t kOfDoubles = 6, kOfUint32 = 13, kOpaque = 17;  // classes of arrays

std::string head() {
  std::string out = "MATLAB 5.0 MAT-file";
  out.resize(116, ' ');
  return out + std::string(8, '\0') + std::string("\x00\x01IM", 4);
}

// "MCOS", the class and where in MATLAB's own store the object lies: six numbers.
std::string object() {
  const std::string store = element(kUint32, words({kOfUint32, 0})) + element(kInt32, words({6, 1})) +
                            element(kInt8, "") + element(kUint32, words({0xDD000000, 2, 1, 1, 1, 1}));
  return element(kMatrix, element(kUint32, words({kOpaque, 0})) + element(kInt8, "out") + element(kInt8, "MCOS") +
                              element(kInt8, "timetable") + element(kMatrix, store));
}

// Doubles of 0: eight bytes each.
std::string noughts(const std::string& name, uint32_t count) {
  return element(kMatrix, element(kUint32, words({kOfDoubles, 0})) + element(kInt32, words({count, 1})) +
                              element(kInt8, name) + element(kDouble, std::string(8 * count, '\0')));
}

std::string refused(const std::string& content) {
  const std::string path = testing::TempDir() + "made_by_hand_" + std::to_string(getpid()) + ".mat";
  std::ofstream(path, std::ios::binary) << content;
  const std::string said = refusal([&] { host_sim::read_mat(path, dampers(1), {}); });
  std::remove(path.c_str());
  return said;
}

TEST(MatObjects, AFileOfAnObjectAloneSaysWhatToDo) {
  const std::string said = refused(head() + object());
  expect_says(said, "object of a MATLAB class");
  expect_says(said, "expected plain arrays of numbers");
  expect_says(said, "writetimetable");
}

TEST(MatObjects, BesideVariablesTheseAreNamed) {
  const std::string said = refused(head() + object() + noughts("weight", 3));
  expect_says(said, "no channel among the variables \"weight\"");
  expect_says(said, "object of a MATLAB class");
}

TEST(MatObjects, BesideChannelsItIsPassedOver) {
  const std::string said = refused(head() + object() + noughts("displacement_1_m", 3));
  expect_says(said, "no time, expected a variable t_s");
  EXPECT_EQ(said, refused(head() + noughts("displacement_1_m", 3)));
}

}  // namespace
