// How times were written: to so many decimals or digits, or as numbers of single precision.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim {

// The place of the last decimal, decade by decade of the times from the latest on. Numbers of so many
// significant digits have a place ten times finer a decade earlier; some programs write those up to a second, and decimals
// from there on.
struct Written {
  double place_s = 0.0;          // the coarsest of decades that hold enough times to tell; 0: not so written
  int latest = 0;                // decade
  std::vector<double> places_s;  // of the latest decade, the one before, ...
  bool finer_early() const { return !places_s.empty() && places_s.back() < 0.5 * place_s; }
  double place_of(double t) const { return places_s.empty() ? place_s : places_s[index_of(t)]; }
  size_t index_of(double t) const;
};

// 0.001 s for 0.977 and 1.950. latest_s: the largest of them; spacing_s: of numbers as large as they were read (0: next to nothing).
Written in_decimals(const std::vector<double>& time_s, double latest_s, double spacing_s);

// Numbers of single precision: their spacing at the latest time.
Written in_single_precision(const std::vector<double>& time_s, double latest_s);

}  // namespace host_sim
