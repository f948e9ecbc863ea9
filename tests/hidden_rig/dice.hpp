// Random numbers of the hidden-effect generator: the same seed gives the same draws with every standard library.
#pragma once
#include <cmath>
#include <cstdint>

namespace hidden_rig {

class Dice {  // splitmix64
 public:
  explicit Dice(uint64_t seed) : state_(seed) {
    for (int i = 0; i < 3; ++i) state_ = bits() ^ (seed << (7 * i));  // neighbouring seeds share nothing
  }
  uint64_t bits() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  double uniform() { return (static_cast<double>(bits() >> 11) + 0.5) / 9007199254740992.0; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double log_between(double low, double high) { return low * std::exp(uniform() * std::log(high / low)); }
  int below(int count) { return static_cast<int>(bits() % static_cast<uint64_t>(count)); }
  double sign() { return bits() & 1 ? 1.0 : -1.0; }
  bool chance(double probability) { return uniform() < probability; }
  double gauss() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  uint64_t state_;
};

}  // namespace hidden_rig
