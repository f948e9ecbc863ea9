// gnuplot as a child process: the script goes to its stdin, the pictures come from its stdout.
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "host_sim/reports/plot.hpp"

extern char** environ;

namespace host_sim::reports {
namespace {

struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw DrawingError(std::string("no pipe to gnuplot: ") + std::strerror(errno));
    read_end = ends[0];
    write_end = ends[1];
  }
  ~Pipe() {
    close_end(read_end);
    close_end(write_end);
  }
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

void set_nonblocking(int file) { fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK); }

// A child that ends early must be an answer, not a signal that ends us.
struct NoBrokenPipeSignal {
  struct sigaction before {};
  NoBrokenPipeSignal() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before);
  }
  ~NoBrokenPipeSignal() { sigaction(SIGPIPE, &before, nullptr); }
};

pid_t start(Pipe& in, Pipe& out, Pipe& error) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.read_end, 0);
  posix_spawn_file_actions_adddup2(&actions, out.write_end, 1);
  posix_spawn_file_actions_adddup2(&actions, error.write_end, 2);
  char name[] = "gnuplot", no_rc[] = "-d";
  char* arguments[] = {name, no_rc, nullptr};
  pid_t child = -1;
  const int failure = posix_spawnp(&child, name, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT)
    throw DrawingError("the report needs gnuplot, which is not installed (Debian: apt-get install gnuplot-nox)");
  if (failure != 0) throw DrawingError(std::string("gnuplot does not start: ") + std::strerror(failure));
  return child;
}

bool read_some(int& file, std::string& into) {
  char buffer[65536];
  const ssize_t count = read(file, buffer, sizeof buffer);
  if (count > 0) into.append(buffer, static_cast<size_t>(count));
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) Pipe::close_end(file);
  return count > 0;
}

void exchange(int& to_child, const std::string& script, int& from_child, std::string& out, int& errors,
              std::string& messages) {
  size_t sent = 0;
  while (from_child >= 0 || errors >= 0) {
    pollfd waits[3] = {{to_child, POLLOUT, 0}, {from_child, POLLIN, 0}, {errors, POLLIN, 0}};
    if (poll(waits, 3, -1) < 0 && errno != EINTR) break;
    if (to_child >= 0 && waits[0].revents) {
      const ssize_t count = write(to_child, script.data() + sent, script.size() - sent);
      if (count > 0) sent += static_cast<size_t>(count);
      if (sent == script.size() || (count < 0 && errno != EAGAIN && errno != EINTR)) Pipe::close_end(to_child);
    }
    if (waits[1].revents) read_some(from_child, out);
    if (waits[2].revents) read_some(errors, messages);
  }
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  NoBrokenPipeSignal quiet;
  Pipe in, out, error;
  const pid_t child = start(in, out, error);
  Pipe::close_end(in.read_end);
  Pipe::close_end(out.write_end);
  Pipe::close_end(error.write_end);
  set_nonblocking(in.write_end);
  set_nonblocking(out.read_end);
  set_nonblocking(error.read_end);
  std::string pictures, messages;
  exchange(in.write_end, script, out.read_end, pictures, error.read_end, messages);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw DrawingError("gnuplot failed: " + (messages.empty() ? std::string("no message") : messages));
  return pictures;
}

}  // namespace host_sim::reports
