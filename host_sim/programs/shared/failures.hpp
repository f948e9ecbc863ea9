// How a command ends when it does not end well; the exit status follows from the type (docs/formats.md).
#pragma once
#include <stdexcept>
#include <string>

namespace host_sim {

enum class ExitStatus { kDone = 0, kOther = 1, kBadInput = 2, kCannotAnswer = 3 };

// A command line that cannot be followed: status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The data cannot answer the question; the message says why and what to measure instead: status 3.
class CannotAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Runs the body and turns what it throws into a message on stderr and an exit status.
template <typename Body>
int guarded(Body body);
int report_failure() noexcept;  // of the exception in flight

template <typename Body>
int guarded(Body body) {
  try {
    body();
    return static_cast<int>(ExitStatus::kDone);
  } catch (...) {
    return report_failure();
  }
}

}  // namespace host_sim
