// host_sim watch: what a rig says, in a table that stays in place.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "host_sim/live/terminal/session.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/programs/shared/terminal.hpp"

namespace host_sim {
namespace {

struct WatchSettings {
  std::string source = "-";
  bool once = false;
  double speed = 1.0, bit_rate_kbit_s = 1000.0, data_bit_rate_kbit_s = 2000.0, trend_min = 3.0, seconds = 3.0;
  int node = 0;
};

enum class SourceKind { kText, kFile, kInterface };

SourceKind kind_of(const std::string& source) {
  if (source == "-") return SourceKind::kText;
  std::error_code ignored;
  return std::filesystem::exists(source, ignored) ? SourceKind::kFile : SourceKind::kInterface;
}

std::unique_ptr<live::FrameFeed> open_feed(const std::string& source, SourceKind kind) {
  switch (kind) {
    case SourceKind::kText:
      return live::text_feed(hal::FileDescriptor(::dup(STDIN_FILENO)));
    case SourceKind::kFile: {
      hal::FileDescriptor file(::open(source.c_str(), O_RDONLY | O_CLOEXEC));
      if (!file || std::filesystem::is_directory(source))
        throw UsageError(source + ": cannot be read, expected a candump log");
      return live::text_feed(std::move(file));
    }
    case SourceKind::kInterface:
      break;
  }
  try {
    return live::interface_feed(source);
  } catch (const std::runtime_error& error) {
    throw UsageError(source + ": no such file, and " + error.what());
  }
}

live::SessionOptions session_options(const WatchSettings& settings, SourceKind kind) {
  live::SessionOptions options;
  options.source = settings.source == "-" ? "standard input" : settings.source;
  options.paced = kind == SourceKind::kFile;
  options.speed = settings.speed;
  options.node = settings.node;
  options.picture.rates.nominal_bit_s = static_cast<int64_t>(settings.bit_rate_kbit_s * 1000.0);
  options.picture.rates.data_bit_s = static_cast<int64_t>(settings.data_bit_rate_kbit_s * 1000.0);
  options.picture.trend_ns = static_cast<uint64_t>(settings.trend_min * 60e9);
  return options;
}

live::SessionResult on_screen(live::FrameFeed& feed, const live::SessionOptions& options) {
  try {
    return live::watch_on_terminal(feed, options);
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
}

live::SessionResult as_text(live::FrameFeed& feed, const live::SessionOptions& options, double seconds) {
  std::string text;
  const live::SessionResult result =
      live::watch_once(feed, options, seconds, terminal_width(stdout), unicode_locale(), text);
  if (result.frames > 0) std::fwrite(text.data(), 1, text.size(), stdout);
  return result;
}

void watch(const WatchSettings& settings) {
  const SourceKind kind = kind_of(settings.source);
  if (kind == SourceKind::kText && ::isatty(STDIN_FILENO) != 0)
    throw UsageError("watch: expected an interface (can0), a log, or what candump prints through a pipe");
  const std::unique_ptr<live::FrameFeed> feed = open_feed(settings.source, kind);
  const live::SessionOptions options = session_options(settings, kind);
  const bool on_terminal = !settings.once && ::isatty(STDOUT_FILENO) != 0;
  const live::SessionResult result =
      on_terminal ? on_screen(*feed, options) : as_text(*feed, options, settings.seconds);
  if (result.skipped_lines > 0)
    std::fprintf(stderr, "watch: %llu lines skipped: no candump frame\n",
                 static_cast<unsigned long long>(result.skipped_lines));
  if (result.frames == 0 && !on_terminal)
    throw CannotAnswer(options.source + (kind == SourceKind::kInterface
                                             ? ": no CAN frame came, expected a controller that runs"
                                             : ": no CAN frame in it, expected what candump or candump -L prints"));
}

}  // namespace

void add_watch_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("watch", "Show what a rig says in a table that stays in place");
  auto settings = std::make_shared<WatchSettings>();
  command
      ->add_option("SOURCE", settings->source,
                   "CAN interface, candump log, or - for what candump prints through a pipe")
      ->capture_default_str();
  command->add_flag("--once", settings->once, "print the final table and stop; also where stdout is no terminal");
  command->add_option("--speed", settings->speed, "of a log on a terminal; 0: as fast as it can be read")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--node", settings->node, "whose estimates are shown, 1 to 7; 0: the first that is heard")
      ->capture_default_str()
      ->check(CLI::Range(0, 7));
  command->add_option("--bit-rate", settings->bit_rate_kbit_s, "of the bus in kbit/s, for its load")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 1000.0));
  command->add_option("--data-bit-rate", settings->data_bit_rate_kbit_s, "of CAN FD data in kbit/s")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 8000.0));
  command->add_option("--trend", settings->trend_min, "minutes that the trend goes back")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1440.0));
  command->add_option("--seconds", settings->seconds, "how long --once listens to an interface")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0));
  command->footer(
      "Keys, on a terminal: w closes the window now; s, x, r start, stop, reset the node; Tab the next node; q leaves\n"
      "Example: candump -L can0 | host_sim watch -");
  command->callback([settings, &chosen] { chosen = [settings] { watch(*settings); }; });
}

}  // namespace host_sim
