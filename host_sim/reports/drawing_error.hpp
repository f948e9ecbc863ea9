// The pictures of a report cannot be drawn: gnuplot is missing or refuses.
#pragma once
#include <stdexcept>

namespace host_sim::reports {

class DrawingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace host_sim::reports
