#include "hal/rig_file/recorded/moving_samples.hpp"

#include <algorithm>
#include <numeric>

namespace rig_file {

double fewest_moving_samples(const ChannelCodes& records) {
  double fewest = 0.0;
  for (const auto& codes : records) {
    if (codes.empty()) continue;
    const double mean = std::accumulate(codes.begin(), codes.end(), 0.0) / static_cast<double>(codes.size());
    double squares = 0.0, fourths = 0.0;
    for (const double code : codes) {
      const double square = (code - mean) * (code - mean);
      squares += square, fourths += square * square;
    }
    if (!(fourths > 0.0)) continue;
    const double moving = squares * squares / fourths;
    fewest = fewest > 0.0 ? std::min(fewest, moving) : moving;
  }
  return fewest;
}

}  // namespace rig_file
