// Whether the run before this one ended well: a file in a folder that lives until the next boot, there while a program drives the rig. A
// program that crashed, hung or ended with a stop latched leaves it behind; what is started after it waits for START.
#pragma once
#include <string>

namespace board {

class RunMarker {
 public:
  // True where a run left its marker in the folder; from here on this run's is there. An empty folder, or one that takes no file: false,
  // and nothing is remembered.
  bool begin(const std::string& folder);
  // This run ends with the rig safe and nothing latched.
  void end_well();

 private:
  std::string path_;
};

// systemd's RuntimeDirectory, else /run/rig_controller, made where it can be.
std::string runtime_folder();

}  // namespace board
