// What is wrong with a command line.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace host_sim {

// In one line. A mistyped option is named, with the one that it resembles: CLI11 would say that the one it stands for is missing.
std::string option_error_text(const CLI::App& app, const CLI::ParseError& error);

}  // namespace host_sim
