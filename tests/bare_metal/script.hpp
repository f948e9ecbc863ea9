// A measurement for the core as a file that any machine can read: the configuration's bytes, then what happens, in order.
//
//   "RIG1", u32 length, the bytes of firmware::encode(); then one byte an event and what belongs to it, little-endian:
//   'L'  a level begins
//   'S'  a sample: i32 codes of the present channels, node by node, force to acceleration
//   'W'  the estimates are wanted
//   'E'  the level ends
//   'Q'  the end
#pragma once
#include <cstddef>
#include <cstdint>

namespace bare_metal {

class Bytes {
 public:
  virtual size_t read(uint8_t* bytes, size_t size) = 0;  // the number read

 protected:
  ~Bytes() = default;
};

class Text {
 public:
  virtual void print(const char* text, size_t size) = 0;

 protected:
  ~Text() = default;
};

// Counts the work of a piece of the path; a machine without a counter says 0.
class WorkCounter {
 public:
  virtual uint32_t now() = 0;  // instructions, or any unit; runs over

 protected:
  ~WorkCounter() = default;
};

// What is left of the command line.
struct Words {
  bool plain = false;     // "plain": the paper's products alone
  bool untested = false;  // "untested": without the score tests
  bool frames = false;    // "frames": the whole controller
  bool open = false;      // "open": first batches as where nobody knows how long the levels are
  bool sliced = false;    // "sliced": solves in slices (hal/bare_metal/sliced_worker.hpp)
};
Words read_words(const char* text);

// Of a solve in slices. Where there is an operating system its own part of the machinery comes on top.
#ifdef __linux__
constexpr size_t kSolveStack = 256 * 1024;
#else
constexpr size_t kSolveStack = 8 * 1024;
#endif

// Runs the script through the core and prints each set of estimates as integers (mantissa:exponent), then what the path
// cost: "push: count N total T worst W" and "solve: ..." in the counter's unit, where the counter counts.
// Returns false where the script cannot be read.
bool run_core(Bytes& script, Text& out, WorkCounter& counter, const Words& words);

// Runs the script through a RigController that listens on command, one step() a sample, without a worker, and prints after
// each level how many frames it has sent and their CRC-32 (identifiers, lengths and data), then what the steps cost. With
// "sliced" it has a worker, of which a few slices are run after each step.
bool run_controller(Bytes& script, Text& out, WorkCounter& counter, const Words& words);

inline bool run_script(Bytes& script, Text& out, WorkCounter& counter, const Words& words) {
  return words.frames ? run_controller(script, out, counter, words) : run_core(script, out, counter, words);
}

}  // namespace bare_metal
