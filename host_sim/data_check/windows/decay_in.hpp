// Whether the energy falls within a stretch of windows as that of a free decay.
#pragma once
#include <optional>

#include "host_sim/data_check/windows/between_blows.hpp"

namespace host_sim::data_check {

// In windows; from: the first that has all its energy. Nothing where the span is no decay.
struct Decay {
  size_t from = 0, to = 0;
  double periods = 0.0;  // until it is at rest
  bool clipped = false;  // up to its first
};

std::optional<Decay> decay_in(const Windows& energy, const Span& span);

// Whether a record is one decay: the energy never rises by more than noise and beats make, each quarter has less than the one before, and
// the last less than the first by more than that.
bool falls_throughout(const Windows& energy);

}  // namespace host_sim::data_check
