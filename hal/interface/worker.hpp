// Where a long calculation runs while step() goes on: another thread, or the main loop below a timer interrupt.
#pragma once

namespace hal {

class Worker {
 public:
  // Runs work(argument) once. Only after the one before is done().
  virtual void start(void (*work)(void*), void* argument) = 0;
  // The work has ended and all that it wrote can be read. True before the first start.
  virtual bool done() = 0;
  // Returns when done(): for the rare case in which there is nothing else to do.
  virtual void wait() = 0;

 protected:
  ~Worker() = default;
};

}  // namespace hal
