// rig_controller: the controller on a Linux board.
//
//   open everything -> real time -> wait for a frame, a sample, an edge or the tick -> RigController::step() -> ...
//
// Nothing is allocated between the start and the end of that loop. A test links a function allocation_guard_begin()
// that makes every later allocation fatal.
#include <getopt.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>

#include "firmware/version.hpp"
#include "hal/linux/board/board_devices.hpp"
#include "hal/linux/board/board_file.hpp"
#include "hal/linux/board/bus_check.hpp"
#include "hal/linux/board/run.hpp"
#include "hal/linux/board/safe_outputs.hpp"
#include "hal/rig_file/rig_file_error.hpp"

namespace {

constexpr int kDone = 0, kFailed = 1, kBadInput = 2;
constexpr double kLongestRun_s = 1e9;

constexpr const char* kHelp =
    "usage: rig_controller BOARD.toml            run until stopped (SIGTERM, Ctrl-C)\n"
    "       rig_controller --check BOARD.toml    say what the file makes the board do, and what is wrong with it\n"
    "       rig_controller --safe BOARD.toml     relay off, drive zero, lamp off: after the program that drove them is "
    "gone\n"
    "       rig_controller --bytes BOARD.toml    the same as bytes for a board without Linux (docs/porting.md)\n"
    "  --until-done   end when the excitation programme is through\n"
    "  --for SECONDS  end after that time\n"
    "  --version, --help\n"
    "Exit status: 0 done, 2 usage or a bad file, 1 a device is missing or failed. docs/board.md has the file.\n";

struct Arguments {
  const char* file = nullptr;
  bool check = false;
  bool bytes = false;
  bool safe = false;
  board::RunOptions run;
};

// Returns -1 to go on, else the exit status.
int parse(int count, char** words, Arguments& arguments) {
  const option options[] = {{"check", no_argument, nullptr, 'c'},     {"bytes", no_argument, nullptr, 'b'},
                            {"safe", no_argument, nullptr, 's'},      {"until-done", no_argument, nullptr, 'u'},
                            {"for", required_argument, nullptr, 'f'}, {"version", no_argument, nullptr, 'v'},
                            {"help", no_argument, nullptr, 'h'},      {nullptr, 0, nullptr, 0}};
  for (int letter; (letter = getopt_long(count, words, "ch", options, nullptr)) != -1;) {
    char* end = nullptr;
    switch (letter) {
      case 'c':
        arguments.check = true;
        break;
      case 'b':
        arguments.bytes = true;
        break;
      case 's':
        arguments.safe = true;
        break;
      case 'u':
        arguments.run.until_done = true;
        break;
      case 'f':
        arguments.run.seconds = std::strtod(optarg, &end);
        if (*end == '\0' && arguments.run.seconds > 0.0 && arguments.run.seconds <= kLongestRun_s) break;
        std::fprintf(stderr, "rig_controller: --for %s, expected a number of seconds, at most 1e9\n", optarg);
        return kBadInput;
      case 'v':
        std::printf("rig_controller %d.%d.%d, %s\n", firmware::kVersionMajor, firmware::kVersionMinor,
                    firmware::kVersionPatch, hal::GpioLine::library());
        return kDone;
      case 'h':
        std::fputs(kHelp, stdout);
        return kDone;
      default:
        std::fputs(kHelp, stderr);
        return kBadInput;
    }
  }
  if (optind + 1 != count) {
    std::fprintf(stderr, "rig_controller: expected one board file\n%s", kHelp);
    return kBadInput;
  }
  arguments.file = words[optind];
  return -1;
}

// The elements of an array of bytes, sixteen a line.
void print_bytes(const firmware::ControllerConfiguration& configuration) {
  const auto bytes = std::make_unique<uint8_t[][firmware::kConfigurationBytes]>(1);
  const size_t size = firmware::encode(configuration, bytes[0]);
  for (size_t i = 0; i < size; ++i) std::printf("0x%02X,%c", bytes[0][i], i % 16 == 15 || i + 1 == size ? '\n' : ' ');
}

int run_board(const Arguments& arguments) {
  if (arguments.safe) return board::make_board_safe(arguments.file);
  const board::BoardFile file = board::read_board_file(arguments.file);
  if (arguments.bytes) {
    print_bytes(file.controller);
    return kDone;
  }
  if (arguments.check) {
    std::fputs(board::describe(file).c_str(), stdout);
    board::require_bus(file);
    return kDone;
  }
  const board::BusCheck bus = board::check_bus(file);
  if (!bus.fits) std::fprintf(stderr, "rig_controller: the bus may be too slow: %s\n", bus.load.c_str());
  const auto devices = std::make_unique<board::BoardDevices>(file);
  const std::string fault = devices->open();
  if (!fault.empty()) {
    std::fprintf(stderr, "rig_controller: %s\n", fault.c_str());
    return kFailed;
  }
  std::fputs(devices->notes().c_str(), stderr);
  return board::run(file, *devices, arguments.run) ? kDone : kFailed;
}

}  // namespace

int main(int count, char** words) {
  Arguments arguments;
  const int status = parse(count, words, arguments);
  if (status >= 0) return status;
  try {
    return run_board(arguments);
  } catch (const rig_file::RigFileError& error) {
    std::fprintf(stderr, "rig_controller: %s\n", error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rig_controller: %s\n", error.what());
    return kFailed;
  }
}
