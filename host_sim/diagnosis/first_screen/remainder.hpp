// What the search's model leaves over, against sensor noise.
#pragma once
#include <string>

#include "../search/search.hpp"

namespace diagnosis {

// What is left is no noise, nor what the motion is uncertain by.
bool far_beyond_noise(const Rows& rows, const SearchResult& found);

struct Remainder {
  bool noise_only = false;
  std::string trace;  // of something outside the vocabulary, where there is a plain one
  // Beside it only noise is left: what the rows take for noise is noise, and the trace is none of it. A hum is no trace.
  bool trace_alone = false;
  double trace_Hz = 0;  // of a tone
  int trace_link = -1;  // with whose elongation it repeats; none: -1
};
// Leaves the rows' weights settled on the model.
Remainder remainder_of(Rows& rows, const CandidateBank& bank, const SearchResult& found);

}  // namespace diagnosis
