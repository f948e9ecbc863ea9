// Input that cannot be used, and what host_sim must say about it.
#pragma once
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace bad_input {

struct Case {
  std::string name;
  std::map<std::string, std::string> files;  // in the working folder: name, content
  std::vector<std::string> arguments;        // of host_sim
  std::string input;                         // stdin
  std::vector<std::string> says;             // each must stand in stderr
};
inline void PrintTo(const Case& bad, std::ostream* output) { *output << bad.name; }

std::string good_rig();                       // one mass, spring, unknown damper
std::string good_data();                      // its free decay, 2 s at 1 kHz
std::vector<std::string> estimate_command();  // of rig.toml and data.csv, with all outputs

std::vector<Case> broken_rigs();
std::vector<Case> broken_data();
std::vector<Case> broken_commands();

}  // namespace bad_input
