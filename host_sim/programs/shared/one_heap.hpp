// Memory for commands that go through a few large tables, one stage after the other, in threads of their own.
#pragma once

namespace host_sim {

// From now on all threads share one heap, so that a stage finds the memory that the one before it has let go, and the heap's first
// part is in large pages where the system has such: asking for pages one by one takes a tenth of the time of a short recording.
// Not for many threads that ask for memory all the time.
void use_one_heap();

}  // namespace host_sim
