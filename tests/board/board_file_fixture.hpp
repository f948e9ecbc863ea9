// Board files in a folder of their own.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "hal/linux/board/board_file.hpp"

namespace board_test {

class InItsFolder : public testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/board_file_XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    folder_ = folder;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  board::BoardFile read(const std::string& text) const {
    std::ofstream(folder_ + "/board.toml") << text;
    return board::read_board_file(folder_ + "/board.toml");
  }
  std::string folder_;
};

}  // namespace board_test
