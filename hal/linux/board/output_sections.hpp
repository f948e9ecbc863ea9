// The parts of the board's file that say where its outputs and lines are: [node] (its number), [can], [gpio], [drive].
#pragma once
#include <string>
#include <vector>

#include "hal/linux/board/board_file.hpp"
#include "hal/linux/board/toml_section.hpp"

namespace board {

Section node_section(const std::string& file, const toml::table& root);
Section can_section(const std::string& file, const toml::table& root);
Section gpio_section(const std::string& file, const toml::table& root);
Section drive_section(const std::string& file, const toml::table& root);

void read_identity(const Section& node, BoardFile& board);  // the node's number and its watchdog
void read_can(const Section& section, BoardFile& board);
void read_gpio(const Section& section, BoardFile& board);
void read_drive(const Section& section, BoardFile& board);

const std::vector<std::string>& bias_words();  // in the order of hal::LineBias

// What is needed to bring the outputs to their safe state, read for that alone: a mistake elsewhere in the file is no
// matter, and one here costs no more than the section it stands in. problems: what could not be read, in words.
BoardFile read_outputs(const std::string& path, std::vector<std::string>& problems);

}  // namespace board
