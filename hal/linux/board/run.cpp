#include "hal/linux/board/run.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "hal/linux/board/run_marker.hpp"
#include "hal/linux/system/real_time.hpp"

// Defined by tests alone: from here on an allocation is an error.
extern "C" void allocation_guard_begin() __attribute__((weak));

namespace board {
namespace {

hal::FileDescriptor catch_end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  // whatever asks a program to end: a closed terminal and the quit key too
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&signals, signal);
  // whoever reads the messages may have gone
  if (::signal(SIGPIPE, SIG_IGN) == SIG_ERR) return {};
  if (::sigprocmask(SIG_BLOCK, &signals, nullptr) != 0) return {};
  return hal::FileDescriptor(::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
}

// The controller must be run often enough to notice samples that do not come: once per sample, within reason.
uint64_t tick_ns(const BoardFile& file) {
  return std::clamp<uint64_t>(static_cast<uint64_t>(1e9 / file.samples.rate_Hz), 250000, 10000000);
}

// Written with one call and from the stack: nothing is allocated. A terminal that is held (Ctrl-S), a pipe that nobody empties would
// hold the loop and with it the stop line: what cannot be written at once is not said.
template <typename... Values>
void say(const char* format, Values... values) {
  char text[240];
  const int size = std::snprintf(text, sizeof text, format, values...);
  pollfd messages{STDERR_FILENO, POLLOUT, 0};
  if (size > 0 && ::poll(&messages, 1, 0) == 1 && (messages.revents & POLLOUT) != 0)
    static_cast<void>(!::write(STDERR_FILENO, text, std::min<size_t>(static_cast<size_t>(size), sizeof text - 1)));
}

bool measures(firmware::ControllerMode mode) {
  return mode == firmware::ControllerMode::kIntegrate || mode == firmware::ControllerMode::kFreeDecay;
}

class Loop {
 public:
  explicit Loop(BoardDevices& devices) : devices_(devices), controller_(devices.configuration(), devices.ports()) {}

  bool set_up(uint64_t period_ns) {
    end_ = catch_end_signals();
    return end_ && ticker_.start(period_ns);
  }

  void wait_for_start() { controller_.wait_for_start(); }
  bool stop_is_latched() const { return static_cast<bool>(controller_.latched_alarm()); }

  void run(const RunOptions& options) {
    const uint64_t start_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
    const auto limit_ns = static_cast<uint64_t>(options.seconds * 1e9);
    devices_.systemd().ready();
    while (!asked_to_end()) {
      const firmware::ControllerMode before = controller_.mode();
      const uint64_t woken_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
      controller_.step();
      const uint64_t taken_ns = hal::read_clock_ns(CLOCK_MONOTONIC) - woken_ns;
      if (measures(before) && controller_.mode() == before) longest_step_ns_ = std::max(longest_step_ns_, taken_ns);
      tell_changes();
      if (options.until_done && controller_.finished() && controller_.transmit_queue().waiting() == 0) return;
      if (limit_ns > 0 && hal::read_clock_ns(CLOCK_MONOTONIC) - start_ns >= limit_ns) return;
      wait();
      ticker_.take();
    }
  }

  void report() const {
    const firmware::CoreHealth& core = controller_.core().health();
    say("rig_controller: %u samples, %u missed, %u saturated; %llu ticks, %llu late; longest step while measuring %llu "
        "us\n",
        core.samples, core.missed_samples, core.saturated_samples, static_cast<unsigned long long>(ticker_.ticks()),
        static_cast<unsigned long long>(ticker_.missed()), static_cast<unsigned long long>(longest_step_ns_ / 1000));
    const hal::SocketCanCounters& bus = devices_.bus().counters();
    say("rig_controller: CAN %llu sent, %llu received, %llu error frames, %llu refused by a full queue, %llu times "
        "down, %u "
        "bus-off, %u given up\n",
        static_cast<unsigned long long>(bus.sent), static_cast<unsigned long long>(bus.received),
        static_cast<unsigned long long>(bus.error_frames), static_cast<unsigned long long>(bus.queue_full),
        static_cast<unsigned long long>(bus.interface_down), controller_.bus().bus_off_count(),
        controller_.transmit_queue().given_up());
    if (const firmware::AssemblyHealth* assembly = devices_.assembly())
      say("rig_controller: %u samples from sensor frames, %u lost, %u frames lost, %u late\n", assembly->samples,
          assembly->lost_samples, assembly->lost_frames, assembly->late_frames);
  }

 private:
  bool asked_to_end() {
    signalfd_siginfo signal;
    return ::read(end_.get(), &signal, sizeof signal) == static_cast<ssize_t>(sizeof signal);
  }

  void wait() {
    pollfd waits[BoardDevices::kMaxWaits];
    pollfd all[BoardDevices::kMaxWaits + 2];
    const int count = devices_.waits(waits);
    for (int i = 0; i < count; ++i) all[i] = waits[i];
    all[count] = {ticker_.descriptor(), POLLIN, 0};
    all[count + 1] = {end_.get(), POLLIN, 0};
    ::poll(all, static_cast<nfds_t>(count) + 2, -1);
    // A socket of an interface that is down reports its error for as long as it is down: sleep until the tick instead.
    bool useful = false, broken = false;
    for (int i = 0; i < count + 2; ++i) {
      useful = useful || (all[i].revents & POLLIN) != 0;
      broken = broken || (all[i].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0;
    }
    if (broken && !useful) ::poll(all + count, 2, -1);
  }

  void tell_changes() {
    tell_changed_mode();
    // The line's level may be seen before the kernel delivers the edge with its time.
    if (stopped_ns_ == 0 || devices_.stop_edge_ns() <= told_edge_ns_) return;
    told_edge_ns_ = devices_.stop_edge_ns();
    say("rig_controller: drive zero and relay off %llu us after the edge\n",
        static_cast<unsigned long long>((std::max(stopped_ns_, told_edge_ns_) - told_edge_ns_) / 1000));
    stopped_ns_ = 0;
  }

  void tell_changed_mode() {
    const firmware::ControllerMode mode = controller_.mode();
    const firmware::AlarmCause cause = controller_.latched_alarm().cause;
    if (mode == mode_ && cause == cause_) return;
    if (cause == firmware::AlarmCause::kEmergencyStop) stopped_ns_ = hal::read_clock_ns(CLOCK_MONOTONIC);
    mode_ = mode;
    cause_ = cause;
    // As in docs/controller.md, "What stops the drive".
    static constexpr const char* kCauses[] = {"",
                                              ": emergency stop",
                                              ": sensor saturated",
                                              ": samples lost",
                                              ": source failed",
                                              ": drive limit",
                                              ": response limit",
                                              ": run late",
                                              ": drive refused",
                                              ": relay refused",
                                              ": worker late",
                                              ": bad programme"};
    static_assert(std::size(kCauses) == static_cast<size_t>(firmware::AlarmCause::kConfiguration) + 1);
    static constexpr const char* kModes[] = {"starting",   "idle", "ramp",           "settling", "measuring",
                                             "free decay", "done", "emergency stop", "fault"};
    const bool fault = mode == firmware::ControllerMode::kFault && firmware::stops_drive(cause);
    say("rig_controller: %s%s%s\n", kModes[static_cast<int>(mode)], fault ? kCauses[static_cast<int>(cause)] : "",
        cause == firmware::AlarmCause::kNone ? "" : " (drive zero, relay off)");
    devices_.systemd().status(kModes[static_cast<int>(mode)]);
  }

  BoardDevices& devices_;
  firmware::RigController controller_;
  hal::FileDescriptor end_;
  hal::Ticker ticker_;
  uint64_t longest_step_ns_ = 0;
  uint64_t stopped_ns_ = 0;    // of an emergency stop whose edge has not been told; else 0
  uint64_t told_edge_ns_ = 0;  // the last one
  firmware::ControllerMode mode_ = firmware::ControllerMode::kInitialising;
  firmware::AlarmCause cause_ = firmware::AlarmCause::kNone;
};

// The watchdog is disarmed only where the rig is safe without the program; else it resets the board.
bool leave_safe(BoardDevices& devices) {
  const bool safe = devices.make_safe();
  if (safe)
    devices.stop_watchdog();
  else
    say("rig_controller: drive zero or relay off was not delivered\n");
  return safe;
}

}  // namespace

bool run(const BoardFile& file, BoardDevices& devices, const RunOptions& options) {
  const auto loop = std::make_unique<Loop>(devices);
  const std::string refused = hal::become_real_time(file.priority);
  if (!loop->set_up(tick_ns(file))) {
    say("rig_controller: no timer or no signals\n");
    leave_safe(devices);
    return false;
  }
  say("rig_controller: node %d on %s, %s%s; %s\n", int(file.controller.node.node), file.can_interface.c_str(),
      refused.empty() ? "real time" : "not real time: ", refused.c_str(), devices.guard().c_str());
  RunMarker marker;
  if (marker.begin(runtime_folder())) {
    loop->wait_for_start();
    say("rig_controller: the run before was stopped, or did not end well: nothing moves before START\n");
  }
  if (allocation_guard_begin != nullptr) allocation_guard_begin();
  loop->run(options);
  devices.systemd().stopping();
  const bool safe = leave_safe(devices);
  if (safe && !loop->stop_is_latched()) marker.end_well();
  devices.wait_for_workers();
  loop->report();
  return safe;
}

}  // namespace board
